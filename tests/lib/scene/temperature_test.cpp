// The temperature that a body starts with: a formula for every particle, which softens where it is high.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb {
namespace {

Scene bar(const std::string& scheme, const std::string& material, const std::string& initial) {
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

Snapshot<2> end_of(const Scene& scene) {
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord record;
  EXPECT_TRUE(run<2>(simulation, {}, record).completed());
  return simulation.snapshot();
}

const std::vector<double>& shown(const Snapshot<2>& snapshot, const std::string& name) {
  for (const NamedValues& more : snapshot.more)
    if (more.name == name) return more.values;
  throw std::runtime_error("no " + name);
}

TEST(TemperatureOfTheStart, IsTheFormulaAtEveryParticle) {
  for (const char* scheme : {"eulerian", "updated"}) {
    const Scene scene = bar(scheme, "", "temperature = \"300 + 2e4*X\"\n");
    const Snapshot<2> start = make_simulation<2>(scene).simulation.snapshot(), end = end_of(scene);
    for (std::size_t i = 0; i < start.X.size(); ++i) {
      EXPECT_DOUBLE_EQ(shown(start, "temperature")[i], 300 + 2e4 * start.X[i][0]);
      EXPECT_DOUBLE_EQ(shown(end, "temperature")[i],
                       shown(start, "temperature")[i]);  // nothing heats: no heat_capacity
    }
    // the whole bar strains alike at first, and the warm end flows more: at 690 K yields 35 % of the stress
    double cold = 0, warm = 0;
    for (std::size_t i = 0; i < end.X.size(); ++i) {
      if (end.X[i][0] < 0.004) cold = std::max(cold, shown(end, "plastic strain")[i]);
      if (end.X[i][0] > 0.016) warm = std::max(warm, shown(end, "plastic strain")[i]);
    }
    EXPECT_GT(warm, cold + 1e-3) << scheme;
  }
}

TEST(TemperatureOfTheStart, AUniformOneIsThatOfTheMaterial) {
  for (const char* scheme : {"eulerian", "updated"}) {
    const Snapshot<2> a = end_of(bar(scheme, "temperature = 600\n", "")),
                      b = end_of(bar(scheme, "", "temperature = 600\n")), cold = end_of(bar(scheme, "", ""));
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
