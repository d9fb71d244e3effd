// Scenes of several bodies: what is read, what is said, restarts, walls of one of them.
#include "lib/scene/make_cloud.hpp"
#include "lib/scene/walls_of_scene.hpp"
#include "tests/support/outside.hpp"

namespace plumb::testing {
namespace {

std::string body_named(const std::string& name, const std::string& origin) {
  return fmt::format(
      "[[body]]\nname = \"{}\"\norigin = {}\nsize = [0.5, 0.5]\nspacing = 0.125\nlayout = \"cell\"\n", name,
      origin);
}

/// Two blocks side by side of which the left one flies into the other.
Scene two_blocks(const std::string& scheme, const std::string& more) {
  return parse_scene("[scene]\ndimension = 2\nmax_steps = 30\n" + body_named("left", "[0, 0]") +
                         body_named("right", "[0.5, 0.1]") +
                         "[material]\nyoung = \"1 MPa\"\npoisson = 0\ndensity = 1000\n[initial]\nvelocity = "
                         "[\"2*(X < 0.5)\", \"(X > 0.5)\"]\n[method]\nscheme = \"" +
                         scheme + "\"\n" + more,
                     "test.toml");
}

const std::string rough =
    "[[contact]]\nbetween = [\"right\", \"left\"]\nfriction = 0.2\nstiffness = \"3 MPa\"\n";

TEST(TouchingScene, HasNamesAndContacts) {
  const Scene scene =
      two_blocks("updated", rough + "[output]\n[[output.probe]]\nname = \"p\"\nat = [0.9, 0.3]\n");
  EXPECT_EQ(scene.body.name, "left");
  ASSERT_EQ(scene.others.size(), 1u);
  EXPECT_EQ(scene.others[0].name, "right");
  const TouchOptions touch = touch_of_scene(scene);
  EXPECT_EQ(touch.modulus, 3e6);
  EXPECT_EQ(touch.friction, (std::vector<double>{0, 0.2, 0.2, 0}));
  const Cloud<2> cloud = make_cloud<2>(scene);
  ASSERT_EQ(cloud.size(), 32);
  EXPECT_EQ(cloud.body[15], 0);
  EXPECT_EQ(cloud.body[16], 1);
  EXPECT_NEAR(cloud.box.size[1], 0.6, 1e-15);
  std::string said;
  for (const Statement& of : make_simulation<2>(scene).simulation.account()) said += of.text + "\n";
  EXPECT_NE(said.find("2 (left, right)"), std::string::npos) << said;
  EXPECT_NE(said.find("\"right\" and \"left\": penalty with E* = 3e+06 Pa, friction 0.2"), std::string::npos)
      << said;
}

/// Slip between bodies is remembered over a restart.
TEST(TouchingScene, ARestartCarriesTheSlip) {
  for (const std::string scheme : {"updated", "eulerian"}) {
    const Scene scene = two_blocks(scheme, rough);
    auto whole = make_simulation<2>(scene).simulation, first = make_simulation<2>(scene).simulation,
         second = make_simulation<2>(scene).simulation;
    RunRecord record, halves;
    run<2>(whole, {}, record);
    run<2>(
        first, [&] { return first.steps.now().step < 17; }, halves);
    second.restore(first.save());
    run<2>(second, {}, halves);
    const SavedState a = whole.save(), b = second.save();
    ASSERT_EQ(a.fields.size(), b.fields.size());
    for (std::size_t k = 0; k < a.fields.size(); ++k)
      EXPECT_EQ(a.fields[k].values, b.fields[k].values) << scheme << ' ' << a.fields[k].name;
    ASSERT_NE(field_named(a.fields, "slip between bodies"), nullptr);
    EXPECT_NE(field_named(a.fields, "work of contact")->values[0], 0);
  }
}

/// A wall of one body lets the others through.
TEST(TouchingScene, AWallIsThatOfItsBody) {
  for (const std::string scheme : {"updated", "eulerian"}) {
    double pushed[2];
    for (const bool own : {false, true}) {
      // right of both: only the right one has come there
      const Scene scene = two_blocks(
          scheme,
          fmt::format("[[contact]]\nbetween = [\"{}\", \"wall\"]\npoint = [0.99, 0]\nnormal = [-1, 0]\n",
                      own ? "right" : "left"));
      auto simulation = make_simulation<2>(scene).simulation;
      pushed[own] = simulation.reactions().at(0).force[0];
    }
    EXPECT_EQ(pushed[0], 0) << scheme;
    EXPECT_LT(pushed[1], 0) << scheme;
  }
}

}  // namespace
}  // namespace plumb::testing
