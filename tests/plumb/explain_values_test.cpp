// The numbers of `plumb explain`: against closed forms, and against a run of the same scene.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;

constexpr double young = 17e6, poisson = 0.3, density = 1100, spacing = 0.1;
constexpr long along = 11;  // particles on an edge of 1 m

/// A square at rest: the time step stays what it is at the start.
class ValuesOfExplain : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder / "scene.toml") << R"([scene]
name = "square"
dimension = 2
end_time = 1e-3
[body]
size = [1, 1]
spacing = 0.1
layout = "node"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
integrator = "rk3"
)";
  }
  json result(const std::string& command, const std::string& changes, const std::string& more = "") const {
    const auto outcome = run_plumb(command + " " + (folder / "scene.toml").string() +
                                   " --json - --threads 1 " + changes + more);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return json::parse(outcome.out);
  }
  json explained(const std::string& changes = "") const { return result("explain", changes); }
  json run(const std::string& changes = "") const {
    return result("run", changes, " --out " + (folder / "out").string());
  }
  test::TemporaryFolder folder;
};

/// rho c_p^2 = kappa + 4/3 mu.
double wave_speed() {
  const double mu = young / (2 * (1 + poisson)), kappa = young / (3 * (1 - 2 * poisson));
  return std::sqrt((kappa + 4 * mu / 3) / density);
}

TEST_F(ValuesOfExplain, ParticlesNeighboursAndTimeStepHaveTheirClosedForms) {
  const json said = explained("--set method.cfl=0.4");
  EXPECT_EQ(said["particles"], along * along);
  // R = 1.8 d reaches the 8 particles around: pairs of places that differ by at most one in both directions,
  // less the particle itself
  const double pairs = std::pow(3 * along - 2, 2) - along * along;
  EXPECT_DOUBLE_EQ(said["neighbours"]["mean"].get<double>(), pairs / (along * along));
  EXPECT_EQ(said["neighbours"]["max"], 8);
  EXPECT_EQ(said["evaluations_per_step"], 3);
  // the spacing between two particles is a difference of rounded coordinates
  EXPECT_NEAR(said["dt"].get<double>() * wave_speed() / (0.4 * spacing), 1, 1e-12);
  EXPECT_EQ(said["steps"], std::lround(std::ceil(1e-3 * wave_speed() / (0.4 * spacing))));
}

struct Steps {
  const char* changes;
  long steps;
};

/// The last step is shortened, so the count is rounded up; an end on a step is no further one.
TEST_F(ValuesOfExplain, StepsAreRoundedUp) {
  for (const Steps& row :
       {Steps{"--set method.time_step=1e-4 --set scene.end_time=7.3e-4", 8},
        Steps{"--set method.time_step=1e-4 --set scene.end_time=7.9e-4", 8},
        Steps{"--set method.time_step=1e-4 --set scene.end_time=7e-4", 7},
        Steps{"--set method.time_step=1e-4 --set scene.end_time=0.2e-4", 1},
        Steps{"--set method.time_step=1e-4 --set scene.max_steps=5", 5},
        Steps{"--set method.time_step=1e-4 --set scene.max_steps=50", 10},
        // 4 + 4 steps for two intervals, and 3 for the rest of 0.3 ms
        Steps{"--set method.time_step=1e-4 --set output.every=3.5e-4 --set output.series=true", 11}}) {
    EXPECT_EQ(explained(row.changes)["steps"], row.steps) << row.changes;
    EXPECT_EQ(run(row.changes)["steps"], row.steps) << row.changes;
  }
}

TEST_F(ValuesOfExplain, ARunTakesTheStepsMemoryAndEvaluationsThatWereSaid) {
  for (const char* changes : {"", "--set method.integrator=verlet", "--set body.jitter=0.2",
                              "--set jst.eta4=0.01", "--set method.cfl=0.33 --set hourglass.alpha=0.5"}) {
    SCOPED_TRACE(changes);
    const json said = explained(changes), done = run(changes);
    EXPECT_EQ(said["steps"], done["steps"]);
    EXPECT_EQ(said["dt"], done["dt"]["first"]);
    EXPECT_EQ(said["particles"], done["particles"]);
    EXPECT_EQ(said["neighbours"], done["neighbours"]);
    EXPECT_EQ(said["memory"]["bytes_per_particle"], done["memory"]["bytes_per_particle"]);
    EXPECT_EQ(said["built"], done["built"]);
    const long steps = done["steps"], particles = done["particles"], each = said["evaluations_per_step"];
    const long evaluations = done["work"]["particle_evaluations"];
    // Verlet needs the force of the start before its first step
    EXPECT_GE(evaluations, steps * each * particles);
    EXPECT_LE(evaluations, (steps * each + 1) * particles);
  }
}

TEST_F(ValuesOfExplain, MemoryIsTheSumOfItsArraysAndVectorsHaveTheirSize) {
  const json said = explained();
  double sum = 0, displacement = 0;
  for (const auto& array : said["arrays"]) {
    sum += array["bytes"].get<double>();
    if (array["name"] == "displacement") displacement = array["bytes"];
  }
  EXPECT_EQ(said["memory"]["bytes"].get<double>(), sum);
  EXPECT_DOUBLE_EQ(said["memory"]["bytes_per_particle"].get<double>(), sum / (along * along));
  // two doubles a particle, each line of the lattice filled up to a whole number of packs of at most 8
  EXPECT_GE(displacement, 2 * 8 * along * along);
  EXPECT_LE(displacement, 2 * 8 * (along + 1) * (along + 7 + 8));
}

}  // namespace
}  // namespace plumb
