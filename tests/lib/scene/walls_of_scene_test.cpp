// Bodies of the schemes updated and eulerian against walls: budgets, rests, slides, restarts.
#include <cmath>
#include <fstream>

#include "lib/core/error.hpp"
#include "tests/support/outside.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::testing {
namespace {

const std::vector<std::string> touching = {"updated", "eulerian"};

std::string floor_at(double y, const std::string& more = "") {
  return fmt::format("[[contact]]\nbetween = [\"body\", \"floor\"]\npoint = [0, {}]\nnormal = [0, 2]\n{}", y,
                     more);
}

/// A block that stands on a floor: the force of the floor is its weight.
TEST(ContactScene, AFloorBearsTheWeight) {
  for (const auto& scheme : touching)
    for (const char* layout : {"node", "cell"}) {
      Scene scene = parse_scene(block(2, scheme,
                                      "[load]\ngravity = [0, \"-10\"]\n[relaxation]\nresidual = 1e-7\n" +
                                          floor_at(0, "stiffness = \"2 MPa\"\n")),
                                "test.toml", {std::string("body.layout=") + layout});
      scene.end_time = 5;
      auto simulation = make_simulation<2>(scene).simulation;
      RunRecord record;
      const RunResult result = run<2>(simulation, {}, record);
      ASSERT_TRUE(result.completed()) << scheme;
      EXPECT_LT(simulation.steps.now().time, 5) << scheme;
      const auto reactions = simulation.reactions();
      ASSERT_EQ(reactions.size(), 1u);
      EXPECT_EQ(reactions[0].boundary, "floor");
      EXPECT_NEAR(reactions[0].force[1] / (1000 * volume(2) * 10), 1, 1e-6) << scheme << ' ' << layout;
      EXPECT_EQ(reactions[0].force[0], 0);
    }
}

/// Mean velocity of a body.
template <int d>
Vec<d> drift(const Snapshot<d>& shown) {
  Vec<d> momentum = Vec<d>::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < shown.v.size(); ++i) {
    momentum += shown.mass[i] * shown.v[i];
    mass += shown.mass[i];
  }
  return momentum / mass;
}

/// A block on a soft rough floor, which it has pressed in by its weight at the start, is slowed down by mu g.
TEST(ContactScene, ABlockIsSlowedDownByFriction) {
  const double g = 10, mu = 0.25, modulus = 2e4, t = 0.02;
  const double pressed =
      5000.0 / 5 / (std::acos(-1.0) / 4 * modulus);  // 5000 N/m on the five particles of a row
  const std::string floor = fmt::format(
      "[[contact]]\npoint = [0, {}]\nnormal = [0, 1]\nstiffness = {}\nfriction = {}\n", pressed, modulus, mu);
  for (const auto& scheme : touching) {
    auto end = run_of<2>(
        block(2, scheme, "[load]\ngravity = [0, \"-10\"]\n[initial]\nvelocity = [20, 0]\n" + floor));
    // for the first 1e-3 s the springs along the floor are stretched; the weight of the block swings by a tenth
    EXPECT_NEAR((20 - drift(end.simulation.snapshot())[0]) / (mu * g * t), 1, 0.15) << scheme;
    const auto works = end.works();
    // the springs below hold half of the weight times their depth, which the swing of the block takes and gives
    const double stored = 0.5 * 5000 * pressed;
    EXPECT_NEAR(works.at("contact"), -500 * 20 * mu * g * t, stored) << scheme;
  }
}

/// A block falls on a floor that is softer than itself: half a period later it leaves with the energy that it came with.
TEST(ContactScene, ABlockBouncesWithItsEnergy) {
  for (const auto& scheme : touching) {
    const std::string neutral =
        scheme == "updated" ? "[updated]\ndissipation = \"none\"\n" : "[eulerian]\ndamping = \"none\"\n";
    Scene scene = parse_scene(block(2, scheme,
                                    "time_step = 1e-3\n[initial]\nvelocity = [0, \"-0.2\"]\n" +
                                        floor_at(0, "stiffness = 5e3\n") + neutral),
                              "test.toml");
    scene.end_time = 0.7;
    auto simulation = make_simulation<2>(scene).simulation;
    RunRecord record;
    double least = 1;
    run<2>(
        simulation,
        [&] {
          least = std::min(least, simulation.energy().kinetic / 10);
          return true;
        },
        record);
    EXPECT_LT(least, 0.02) << scheme;  // it has come to rest in between
    EXPECT_NEAR(drift(simulation.snapshot())[1], 0.2, 2e-3) << scheme;
    for (const auto& [by, done] : simulation.external_work()) {
      EXPECT_EQ(by, "contact");
      EXPECT_NEAR(done / 10, 0, 0.01) << scheme;  // what the block keeps are waves
    }
    EXPECT_EQ(simulation.reactions().at(0).force.norm(), 0) << scheme;
  }
}

/// A box of two triangles a face from `low` to `high`, as an STL file.
std::string box_of_triangles(const Vec<3>& low, const Vec<3>& high) {
  std::string text = "solid box\n";
  const auto corner = [&](int n) {
    return fmt::format("vertex {} {} {}\n", n & 1 ? high[0] : low[0], n & 2 ? high[1] : low[1],
                       n & 4 ? high[2] : low[2]);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : faces)
    for (const int second : {1, 2}) {
      text += "facet normal 0 0 0\nouter loop\n" + corner(face[0]) + corner(face[second]) +
              corner(face[second + 1]);
      text += "endloop\nendfacet\n";
    }
  return text + "endsolid box\n";
}

/// A block falls on a box of triangles as on the half-space of its upper face, also where the box is far off at first.
TEST(ContactScene, TrianglesAreAWall) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "box.stl") << box_of_triangles({-2000, -2000, -1500}, {2500, 2500, -500});
  const std::string start =
      "time_step = 5e-4\n[initial]\nvelocity = [\"0.2\", 0, -1]\n[[contact]]\nfriction = 0.2\n";
  for (const auto& scheme : touching) {
    auto plane = run_of<3>(block(3, scheme, start + "point = [0, 0, 0]\nnormal = [0, 0, 1]\n"));
    auto triangles = run_of<3>(block(3, scheme,
                                     start + "file = \"" + (folder / "box.stl").string() +
                                         "\"\nunit = \"mm\"\ndisplacement = [0, 0, \"0.5\"]\n"));
    const Snapshot<3> a = plane.simulation.snapshot(), b = triangles.simulation.snapshot();
    double bounced = -1;
    for (std::size_t i = 0; i < a.u.size(); ++i) {
      EXPECT_NEAR((a.u[i] - b.u[i]).norm(), 0, 1e-12) << scheme << i;
      bounced = std::max(bounced, a.v[i][2]);
    }
    EXPECT_GT(bounced, 0) << scheme;
  }
}

/// Friction remembers over a restart.
TEST(ContactScene, ARestartCarriesTheAnchors) {
  for (const auto& scheme : touching) {
    Scene scene =
        parse_scene(block(2, scheme,
                          "[load]\ngravity = [0, \"-10\"]\n[initial]\nvelocity = [\"0.4*Y\", \"-1\"]\n" +
                              floor_at(-1e-3, "friction = 0.3\ndisplacement = [\"0.1*t\", \"0.2*t\"]\n")),
                    "test.toml");
    scene.max_steps = 60;
    auto whole = make_simulation<2>(scene).simulation;
    RunRecord record;
    run<2>(whole, {}, record);
    const SavedState a = whole.save();
    for (long stop = 32; stop < 39; ++stop) {
      auto first = make_simulation<2>(scene).simulation, second = make_simulation<2>(scene).simulation;
      RunRecord halves;
      run<2>(
          first, [&] { return first.steps.now().step < stop; }, halves);
      second.restore(first.save());
      run<2>(second, {}, halves);
      const SavedState b = second.save();
      ASSERT_EQ(a.fields.size(), b.fields.size());
      for (std::size_t k = 0; k < a.fields.size(); ++k)
        EXPECT_EQ(a.fields[k].values, b.fields[k].values) << scheme << ' ' << a.fields[k].name << ' ' << stop;
    }
    ASSERT_NE(field_named(a.fields, "anchors of friction"), nullptr);
    EXPECT_NE(field_named(a.fields, "work of contact")->values[0], 0);
  }
}

}  // namespace
}  // namespace plumb::testing
