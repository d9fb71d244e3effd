// The temperature that a body starts with: a formula for every particle, which softens where it is high.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "tests/support/plastic.hpp"

namespace plumb {
namespace {

using testing::shown;

Scene cook_bar(const std::string& scheme, const std::string& material, const std::string& initial) {
  return parse_scene(R"([scene]
dimension = 2
end_time = "4 us"
[body]
size = [0.02, 0.01]
spacing = 0.001
[material]
model = "johnson-cook"
young = "70 GPa"
poisson = 0.3
density = 2700
yield = "300 MPa"
hardening = "100 MPa"
reference_temperature = 300
melting_temperature = 900
)" + material + "[method]\nscheme = \"" +
                         scheme + "\"\n[initial]\nvelocity = [\"2000*X\", \"0\"]\n" + initial,
                     "bar.toml");
}

Snapshot<2> flown(const Scene& scene) {
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord record;
  EXPECT_TRUE(run<2>(simulation, {}, record).completed());
  return simulation.snapshot();
}

TEST(TemperatureOfTheStart, IsTheFormulaAtEveryParticle) {
  for (const char* scheme : {"eulerian", "updated"}) {
    const Scene scene = cook_bar(scheme, "", "temperature = \"300 + 2e4*X\"\n");
    const Snapshot<2> start = make_simulation<2>(scene).simulation.snapshot(), end = flown(scene);
    for (std::size_t i = 0; i < start.X.size(); ++i) {
      EXPECT_DOUBLE_EQ(shown(start, "temperature")[i], 300 + 2e4 * start.X[i][0]);
      EXPECT_DOUBLE_EQ(shown(end, "temperature")[i],
                       shown(start, "temperature")[i]);  // nothing heats: no heat_capacity
    }
    // the whole bar strains alike at first, and the warm half flows more: 580 K leave 53 % of the yield stress, 420 K leave 80 %
    double cold = 0, warm = 0;
    for (std::size_t i = 0; i < end.X.size(); ++i) {
      if (end.X[i][0] < 0.009) cold = std::max(cold, shown(end, "plastic strain")[i]);
      if (end.X[i][0] > 0.011) warm = std::max(warm, shown(end, "plastic strain")[i]);
    }
    EXPECT_GT(warm, 1.2 * cold) << scheme;
    EXPECT_GT(warm, 1e-3) << scheme;
  }
}

TEST(TemperatureOfTheStart, AUniformOneIsThatOfTheMaterial) {
  for (const char* scheme : {"eulerian", "updated"}) {
    const Snapshot<2> a = flown(cook_bar(scheme, "temperature = 600\n", "")),
                      b = flown(cook_bar(scheme, "", "temperature = 600\n")),
                      cold = flown(cook_bar(scheme, "", ""));
    double differs = 0;
    for (std::size_t i = 0; i < a.X.size(); ++i) {
      EXPECT_EQ(a.x[i], b.x[i]) << scheme;
      differs = std::max(differs, std::abs(shown(a, "plastic strain")[i] - shown(cold, "plastic strain")[i]));
    }
    EXPECT_GT(differs, 1e-3) << scheme;
  }
}

}  // namespace
}  // namespace plumb
