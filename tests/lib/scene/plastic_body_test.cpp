// Plasticity in bodies of the total Lagrangian scheme: the history is that of steps, not of stages, it is kept
// in checkpoints, and the plastic work is a part of the energy.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "lib/material/point.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "tests/support/plastic.hpp"

namespace plumb {
namespace {

using testing::copper, testing::shown;

/// Every particle moves as F(t) X says, with turning and turning back: no proportional path.
Scene driven(const std::string& integrator, const std::string& layout) {
  return parse_scene(R"([scene]
dimension = 2
max_steps = 12
[body]
size = [1, 1]
spacing = 0.25
layout = ")" + layout + "\"" +
                         copper + "[method]\nintegrator = \"" + integrator +
                         "\"\ngradient = \"improved\"\ntime_step = 1e-6\n" + R"(
[[boundary]]
where = "X > -1"
kind = "displacement"
displacement = ["0.03*sin(2e5*t)*X + 4e3*t*Y", "0.02*sin(4e5*t)*X - 0.01*sin(3e5*t)*Y"]
)",
                     "driven.toml");
}

Mat<3> gradient_at(double t) {
  Mat<3> F = Mat<3>::Identity();
  F(0, 0) += 0.03 * std::sin(2e5 * t);
  F(0, 1) += 4e3 * t;
  F(1, 0) += 0.02 * std::sin(4e5 * t);
  F(1, 1) -= 0.01 * std::sin(3e5 * t);
  return F;
}

TEST(PlasticBody, HasTheStressOfAPointThatIsLedByItsSteps) {
  for (const std::string integrator : {"verlet", "rk3"})
    for (const std::string layout : {"node", "cell"}) {
      const Scene scene = driven(integrator, layout);
      auto simulation = make_simulation<2>(scene).simulation;
      RunRecord record;
      ASSERT_TRUE(run<2>(simulation, {}, record).completed());
      const MaterialPoint point = make_point(scene.material.law(), scene.material.elastic());
      PointState state;
      double time = 0;
      for (int n = 1; n <= 12; ++n) {
        time += 1e-6;  // as the steps add up
        state = point(gradient_at(time));
      }
      const Snapshot<2> end = simulation.snapshot();
      EXPECT_GT(*state.plastic_strain, 0.04);  // twelve times the strain at yield
      for (std::size_t i = 0; i < end.X.size(); ++i) {
        // F is affine to rounding; the law multiplies that by its modulus
        EXPECT_LT((end.cauchy[i] - state.cauchy).norm(), 1e-9 * 117e9) << integrator << ", " << layout;
        EXPECT_NEAR(shown(end, "plastic strain")[i], *state.plastic_strain, 1e-9);
        EXPECT_GT(shown(end, "plastic work")[i],
                  0.04 * 0.4e9);  // the stress is at least the first yield stress
      }
    }
}

/// A bar that flies against a wall.
Scene bar(const std::string& integrator, const std::string& more = "") {
  return parse_scene(R"([scene]
dimension = 2
end_time = "10 us"
[body]
size = [0.0064, 0.0192]
spacing = 0.0016
layout = "node"
[method]
cfl = 0.3
integrator = ")" + integrator +
                         "\"\n" + copper + R"([initial]
velocity = ["0", "-227"]
[[boundary]]
face = "y-"
kind = "roller"
)" + more,
                     "bar.toml");
}

TEST(PlasticBody, ItsEnergyIsKineticElasticAndPlasticWork) {
  for (const std::string integrator : {"verlet", "rk3"}) {
    auto simulation = make_simulation<2>(bar(integrator)).simulation;
    const double initial = simulation.energy().total();
    RunRecord record;
    ASSERT_TRUE(run<2>(simulation, {}, record).completed());
    const Energy end = simulation.energy();
    ASSERT_EQ(end.more.size(), 1U);
    EXPECT_EQ(end.more[0].name, "plastic work");
    EXPECT_GT(end.more[0].value, 0.2 * initial);
    // q times the plastic strain of a step is the work of the trapezium's end, an error of the step's size; the
    // roller stops the lowest row at once, which takes its energy along
    EXPECT_NEAR(end.total(), initial, 0.06 * initial) << integrator;
  }
}

TEST(PlasticBody, GoesOnFromACheckpointWithTheSameBits) {
  for (const std::string integrator : {"verlet", "rk3"}) {
    auto whole = make_simulation<2>(bar(integrator)).simulation,
         first = make_simulation<2>(bar(integrator)).simulation,
         second = make_simulation<2>(bar(integrator)).simulation;
    RunRecord record, halves;
    run<2>(whole, {}, record);
    const long half = whole.steps.now().step / 2;
    run<2>(
        first, [&] { return first.steps.now().step < half; }, halves);
    second.restore(first.save());
    run<2>(second, {}, halves);
    const SavedState a = whole.save(), b = second.save();
    ASSERT_EQ(a.fields.size(), b.fields.size());
    bool has_history = false;
    for (std::size_t k = 0; k < a.fields.size(); ++k) {
      has_history = has_history || a.fields[k].name == "inverse plastic metric";
      EXPECT_EQ(a.fields[k].values, b.fields[k].values) << a.fields[k].name;
    }
    EXPECT_TRUE(has_history);
  }
}

TEST(PlasticBody, BelowTheYieldStressNothingIsRemembered) {
  Scene scene = bar("verlet");
  scene.material.parameters["yield"] = 1e15;
  auto simulation = make_simulation<2>(scene).simulation;
  const double initial = simulation.energy().total();
  RunRecord record;
  ASSERT_TRUE(run<2>(simulation, {}, record).completed());
  EXPECT_EQ(simulation.energy().more[0].value, 0);
  const Snapshot<2> end = simulation.snapshot();
  for (const double strain : shown(end, "plastic strain")) EXPECT_EQ(strain, 0);
  EXPECT_NEAR(simulation.energy().total(), initial, 0.06 * initial);
}

}  // namespace
}  // namespace plumb
