#include "lib/schemes/tlsph/time/time_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

TEST(CrossingTime, OfTheUndeformedColumnIsThatOfTable1) {
  Box<3> box{Vec<3>(0, 0, 0), Vec<3>(1, 1, 6)};
  Cloud<3> cloud = lattice<3>(box, {5, 5, 30}, Layout::cell);
  const auto o = options<3>(Scheme{}, cloud.spacing);
  const Solid<3> solid = make_solid<3>(std::move(cloud), "neo-hookean", Elastic{17e6, 0.495, 1100}, o);
  const State<3> state = make_state(solid);
  const double crossing = crossing_time(solid, state, WaveSpeed::linear);
  EXPECT_NEAR(0.3 * crossing, 83.042e-6, 1e-9);  // alpha 0.2/C_lin; the paper prints 83.04 us
  EXPECT_NEAR(0.9 * crossing, 249.126e-6, 1e-9);
  for (const WaveSpeed speed : {WaveSpeed::stretch, WaveSpeed::stretch_inverse})
    EXPECT_NEAR(crossing_time(solid, state, speed), crossing,
                1e-12 * crossing);  // no stretch: all readings agree
}

TEST(CrossingTime, SeesTheShortestPairAndTheLeastStretch) {
  const Vec<3> stretch(0.8, 1.1, 1.3);
  for (const double jitter : {0.0, 0.2}) {
    Solid<3> solid = rubber_block<3>(6, Layout::cell, jitter);
    State<3> state = make_state(solid);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      set_vector<3>(state.u, solid.bonds.slots.of(i),
                    (stretch.array() - 1).matrix().cwiseProduct(solid.cloud.X[i]));
    double shortest = 1e9;
    for (Index i = 0; i < solid.cloud.size(); ++i)
      for (Index j = 0; j < i; ++j)
        shortest = std::min(shortest, stretch.cwiseProduct(solid.cloud.X[j] - solid.cloud.X[i]).norm());
    const double c = solid.elastic.wave_speed();
    const double rounding = 1e-11 * shortest / c;
    EXPECT_NEAR(crossing_time(solid, state, WaveSpeed::linear), shortest / c, rounding);
    EXPECT_NEAR(crossing_time(solid, state, WaveSpeed::stretch), shortest / (c * 0.8), rounding);
    EXPECT_NEAR(crossing_time(solid, state, WaveSpeed::stretch_inverse), shortest / c * 0.8, rounding);
  }
}

/// Where the stretch differs from particle to particle, every pair goes by the mean of its two.
TEST(CrossingTime, GoesByTheMeanStretchOfEveryPair) {
  const Solid<2> solid = rubber_block<2>(8, Layout::node, 0.2);
  State<2> state = make_state(solid);
  deform(solid, state, 0.3);
  std::vector<double> stretch;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Mat<2> F = deformation_gradient_of(solid, state, i), C = F.transpose() * F;
    const double half = 0.5 * C.trace();
    stretch.push_back(std::sqrt(half - std::sqrt(half * half - C.determinant())));
  }
  double straight = 1e9, inverse = 1e9;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (Index j = 0; j < i; ++j) {
      if ((solid.cloud.X[j] - solid.cloud.X[i]).norm() >= 2 * solid.smoothing_length) continue;
      const double r = (position_of(solid, state, j) - position_of(solid, state, i)).norm();
      const double mean = 0.5 * (stretch[i] + stretch[j]);
      straight = std::min(straight, r / mean);
      inverse = std::min(inverse, r * mean);
    }
  const double c = solid.elastic.wave_speed();
  EXPECT_DOUBLE_EQ(c,
                   std::sqrt((solid.elastic.bulk_modulus() + 4 * solid.elastic.shear_modulus() / 3) / 1100));
  EXPECT_NEAR(crossing_time(solid, state, WaveSpeed::stretch), straight / c, 1e-9 * straight / c);
  EXPECT_NEAR(crossing_time(solid, state, WaveSpeed::stretch_inverse), inverse / c, 1e-9 * inverse / c);
}

TEST(Run, MeetsTheEndTimeAndCountsWork) {
  Solid<2> solid = rubber_block<2>(8, Layout::cell, 0);
  State<2> state = make_state(solid);
  deform(solid, state, 0.01);
  const ChosenIntegrator<2> integrator = integrator_named<2>("rk3", solid);
  StepControl control;
  control.cfl = 0.3;
  control.fixed_step = control.cfl * crossing_time(solid, state, WaveSpeed::linear);
  control.end_time = 3.3 * *control.fixed_step;
  const RunResult result = run(solid, state, integrator, control);
  EXPECT_TRUE(result.completed());
  EXPECT_DOUBLE_EQ(state.time, *control.end_time);
  EXPECT_EQ(state.step, 4);
  EXPECT_EQ(integrator.workspace->work.particle_evaluations, 4 * 3 * solid.cloud.size());
  EXPECT_EQ(integrator.workspace->work.pair_evaluations, 4 * 3 * solid.bonds.pairs);
}

/// States fall on every multiple of the interval, to the last bit, and no cut step is taken for one that
/// stability asks for.
TEST(Run, MeetsEveryMultipleOfTheInterval) {
  for (const std::string name : {"rk3", "verlet"})
    for (const double share : {0.3, 0.25, 1.0, 2.5}) {  // of the interval
      Solid<2> solid = rubber_block<2>(8, Layout::cell, 0);
      State<2> state = make_state(solid);
      deform(solid, state, 0.01);
      const ChosenIntegrator<2> integrator = integrator_named<2>(name, solid);
      StepControl control;
      control.fixed_step = 0.3 * crossing_time(solid, state, WaveSpeed::linear);
      control.interval = *control.fixed_step / share;
      control.end_time = 5.5 * *control.interval;
      std::vector<double> times;
      const RunResult result =
          run<2>(solid, state, integrator, control, [&](const Solid<2>&, const State<2>& now) {
            times.push_back(now.time);
            return true;
          });
      EXPECT_TRUE(result.completed());
      for (int k = 0; k <= 5; ++k)
        EXPECT_EQ(std::count(times.begin(), times.end(), k * *control.interval), 1) << share << ' ' << k;
      EXPECT_EQ(times.back(), *control.end_time);
      const long each = std::lround(std::ceil(1 / share)), rest = std::lround(std::ceil(0.5 / share));
      EXPECT_EQ(state.step, 5 * each + rest) << share;
      for (std::size_t n = 1; n < times.size(); ++n)
        EXPECT_LE(times[n] - times[n - 1], *control.fixed_step * (1 + 1e-9));
      EXPECT_EQ(result.dt.first, *control.fixed_step);
      EXPECT_EQ(result.dt.least, *control.fixed_step);
      EXPECT_EQ(result.dt.most, *control.fixed_step);
    }
}

TEST(Run, AnExplosionIsStoppedAndTheLastGoodStateKept) {
  Solid<2> solid = rubber_block<2>(8, Layout::cell, 0);
  State<2> state = make_state(solid);
  deform(solid, state, 0.05);
  const ChosenIntegrator<2> integrator = integrator_named<2>("rk3", solid);
  StepControl control;
  control.fixed_step = 20 * crossing_time(solid, state, WaveSpeed::linear);  // far beyond any stability limit
  control.max_steps = 1000;
  const RunResult result = run(solid, state, integrator, control);
  ASSERT_TRUE(result.failure.has_value());
  EXPECT_TRUE(result.failure->cause == Cause::inverted || result.failure->cause == Cause::non_finite);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    EXPECT_TRUE(vector_at<2>(state.u, solid.bonds.slots.of(i)).allFinite());
  EXPECT_TRUE(evaluate(solid, *integrator.workspace, state, state.time,
                       [](const Block&, BlockForce<2>&) {}));  // the kept state is sound
}

/// Blocks far from the trouble have been updated when it is found, others have not.
TEST(Step, ThatFailsLeavesTheStateBeforeIt) {
  for (const std::string name : {"rk3", "verlet"})
    for (const bool at_once : {true, false}) {                // in the first evaluation, or in a later one
      Solid<3> solid = rubber_block<3>(20, Layout::cell, 0);  // 27 blocks
      State<3> state = make_state(solid);
      deform(solid, state, 0.02);
      const ChosenIntegrator<3> integrator = integrator_named<3>(name, solid);
      const double spacing = solid.cloud.spacing, dt = 1e-7;
      const Index last = solid.bonds.slots.of(solid.cloud.size() - 1);
      if (name == "verlet") {
        ASSERT_TRUE(integrator.step(solid, state, dt));
      }
      if (at_once)
        state.u[0][last] -= 3 * spacing;  // through its neighbours
      else
        state.v[0][last] = -3 * spacing / dt;
      const State<3> before = state;
      ASSERT_FALSE(integrator.step(solid, state, dt));
      EXPECT_EQ(state.step, before.step);
      for (Index i = 0; i < solid.bonds.slots.count(); ++i) {
        // Verlet goes back by subtracting what it added: rounding of positions of 1 m and of velocities
        const double u_error = name == "rk3" ? 0 : 1e-15;
        const double v_error = name == "rk3" ? 0 : 1e-15 * (1 + std::abs(before.v[0][i])) + 1e-12;
        ASSERT_NEAR(state.u[0][i], before.u[0][i], u_error) << name << " slot " << i;
        ASSERT_NEAR(state.v[0][i], before.v[0][i], v_error) << name << " slot " << i;
      }
    }
}

}  // namespace
}  // namespace plumb::testing
