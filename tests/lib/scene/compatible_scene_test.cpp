// gradient = "compatible" and its section [compatible] in scenes.
#include <gtest/gtest.h>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

std::string scene_with(const std::string& gradient, const std::string& more = "") {
  return "[scene]\ndimension = 2\nmax_steps = 1\n[body]\nsize = [1, 1]\nspacing = 0.2\njitter = 0.2\n"
         "[material]\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n[method]\ngradient = \"" +
         gradient + "\"\n" + more;
}

std::string message_of(const std::string& text) {
  try {
    parse_scene(text, "test.toml");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(CompatibleScene, IsBuiltWithEitherMomentumFormAndEitherTreatmentOfVolumes) {
  for (const char* momentum : {"adjoint", "symmetrised"})
    for (const char* volumes : {"unknown", "fixed"})
      for (const char* start : {"standard", "improved"}) {
        const Scene scene =
            parse_scene(scene_with("compatible", std::string("[compatible]\nvolumes = \"") + volumes +
                                                     "\"\nstart = \"" + start + "\"\n"),
                        "test.toml", {std::string("method.momentum=") + momentum});
        EXPECT_EQ(scene.method.compatible.volumes, volumes);
        EXPECT_EQ(scene.method.compatible.start, start);
        const auto simulation = make_tlsph<2>(scene);
        EXPECT_EQ(simulation.solid.cloud.size(), 36);
      }
}

/// Whether the table is the closed form, with these changes of a square of nodes.
bool is_closed(const std::vector<std::string>& changes) {
  std::vector<std::string> all{"body.jitter=0"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto simulation = make_tlsph<2>(parse_scene(scene_with("compatible"), "test.toml", all));
  const CompatibleReport& report = *simulation.compatible;
  EXPECT_EQ(report.closed_form, report.why_projected.empty());
  EXPECT_EQ(report.closed_form, report.unknowns == 0);
  return report.closed_form;
}

// The closed form wherever there is one; the projection of a lattice by its name.
TEST(CompatibleScene, ChoosesTheClosedFormOfLattices) {
  EXPECT_TRUE(is_closed({}));
  EXPECT_TRUE(is_closed({"compatible.start=standard", "method.pair=W0", "hourglass.alpha=1"}));
  EXPECT_TRUE(is_closed({"compatible.table=closed-form"}));
  EXPECT_FALSE(is_closed({"compatible.table=projected"}));
  EXPECT_FALSE(is_closed({"body.jitter=0.1"}));
  EXPECT_FALSE(is_closed({"body.layout=cell"}));
  EXPECT_FALSE(is_closed({"body.cloud=blue-noise", "method.beta=1.5"}));
  EXPECT_TRUE(is_closed({"method.beta=1.2"}));
  EXPECT_FALSE(is_closed({"method.beta=1.6"}));
  EXPECT_FALSE(is_closed({"method.momentum=symmetrised"}));
  EXPECT_FALSE(is_closed({"compatible.surface=estimated", "method.beta=1.5"}));
}

TEST(CompatibleScene, RefusesTheClosedFormWhereThereIsNone) {
  for (const char* change : {"body.jitter=0.1", "body.layout=cell", "method.beta=1.6"})
    EXPECT_THROW(is_closed({"compatible.table=closed-form", change}), InputError) << change;
  for (const char* change : {"method.momentum=symmetrised", "compatible.surface=estimated"})
    EXPECT_THROW(parse_scene(scene_with("compatible"), "test.toml", {"compatible.table=closed-form", change}),
                 InputError)
        << change;
}

Scene without_method(const std::vector<std::string>& changes, const std::string& more = "") {
  return parse_scene(
      "[scene]\ndimension = 2\nmax_steps = 1\n[body]\nsize = [1, 1]\nspacing = 0.1\n"
      "[material]\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n" +
          more,
      "test.toml", changes);
}

TEST(DefaultScheme, CompatibleBondsHaveAWiderSupportWhereASurfaceCutsTheCloud) {
  const auto expect = [](const std::vector<std::string>& changes, const char* gradient, double beta) {
    const Scene scene = without_method(changes);
    EXPECT_EQ(scene.method.gradient, gradient);
    EXPECT_EQ(scene.method.beta, beta);
    EXPECT_TRUE(make_tlsph<2>(scene).warnings.empty());
  };
  const std::string improved = "method.gradient=improved",
                    hole = "body.hole=[{shape='ball', centre=[0.5, 0.5], radius=0.25}]";
  expect({}, "compatible", 0.9);
  expect({"body.jitter=0.2"}, "compatible", 0.9);
  expect({hole}, "compatible", 1.2);
  expect({"body.cloud=blue-noise"}, "compatible", 1.2);
  expect({"body.cloud=blue-noise", "method.beta=1.3"}, "compatible", 1.3);
  expect({improved}, "improved", 0.9);
  expect({improved, hole}, "improved", 0.9);
  EXPECT_TRUE(make_tlsph<2>(without_method({})).compatible->closed_form);
}

// Compatible bonds need particles on the surface, and their force is the adjoint one.
TEST(DefaultScheme, IsTheImprovedTableWhereCompatibleBondsDoNotFit) {
  for (const std::vector<std::string>& changes : std::vector<std::vector<std::string>>{
           {"body.layout=cell"}, {"method.momentum=symmetrised"}, {"method.momentum=variational"}})
    EXPECT_EQ(without_method(changes).method.gradient, "improved") << changes.front();
}

TEST(DefaultScheme, PaperOf003HasItsCflNumber) {
  EXPECT_EQ(without_method({"method.paper=003"}).method.mixed.cfl, 0.9);
  EXPECT_EQ(without_method({"method.paper=003", "method.cfl=0.3"}).method.mixed.cfl, 0.3);
}

// One word for the keys of the paper's scenes; a key that is given wins.
TEST(DefaultScheme, PaperIsTheSchemeOfThePaper) {
  const Scene paper = without_method({"method.paper=000"});
  EXPECT_EQ(paper.method.gradient, "improved");
  EXPECT_EQ(paper.method.momentum, "symmetrised");
  EXPECT_EQ(paper.method.integrator, "rk3");
  EXPECT_EQ(paper.method.pair, "W1");
  EXPECT_EQ(paper.method.beta, 0.9);
  ASSERT_TRUE(paper.method.jst);
  EXPECT_EQ(paper.method.jst->eta4, JstOptions{}.eta4);
  const Scene other = without_method({"method.paper=000", "method.gradient=standard", "jst.eta4=0.125"});
  EXPECT_EQ(other.method.gradient, "standard");
  EXPECT_EQ(other.method.momentum, "symmetrised");
  EXPECT_EQ(other.method.jst->eta4, 0.125);
  EXPECT_FALSE(without_method({}).method.jst);
  EXPECT_THROW(without_method({"method.paper=999"}), InputError);
}

TEST(HourglassScene, LeavesNoTraceUnlessItIsNamed) {
  const auto without = make_tlsph<2>(parse_scene(scene_with("compatible"), "test.toml"));
  EXPECT_TRUE(without.solid.terms.empty());
  EXPECT_EQ(without.integrator.workspace->F.components(), 0);
  for (const char* alpha : {"0", "0.5"}) {
    const auto with = make_tlsph<2>(parse_scene(
        scene_with("compatible", std::string("[hourglass]\nalpha = ") + alpha + "\n"), "test.toml"));
    EXPECT_EQ(with.solid.terms.size(), alpha[0] == '0' && alpha[1] == 0 ? 0 : 1) << alpha;
  }
}

TEST(CompatibleScene, ErrorsNameTheNearestKeyAndValue) {
  EXPECT_NE(message_of(scene_with("compatible", "[compatible]\nvolume = \"fixed\"\n")).find("volumes"),
            std::string::npos);
  EXPECT_NE(message_of(scene_with("compatible", "[compatible]\nstart = \"improve\"\n")).find("improved"),
            std::string::npos);
  EXPECT_NE(message_of(scene_with("improved", "[compatible]\nstart = \"standard\"\n")).find("contradicts"),
            std::string::npos);
}

}  // namespace
}  // namespace plumb
