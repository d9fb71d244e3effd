// The bounds at which a run ends, from both sides, with a integrator that does nothing but what the test wants;
// what a run reports.
#include <gtest/gtest.h>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

/// Advances time and then changes the state as told.
ChosenIntegrator<2> integrator_that(const std::function<void(State<2>&)>& change) {
  ChosenIntegrator<2> integrator{};
  integrator.step = [change](const Solid<2>&, State<2>& state, double dt) -> Outcome {
    state.time += dt;
    ++state.step;
    change(state);
    return {};
  };
  return integrator;
}

struct Body {
  Solid<2> solid = rubber_block<2>(6, Layout::cell, 0);
  State<2> state = make_state(solid);
  StepControl control;

  Body() {
    control.fixed_step = 1e-4;
    control.max_steps = 100;
  }
  void set_speed(double v) {
    for (Index i = 0; i < solid.cloud.size(); ++i) state.v[0][solid.bonds.slots.of(i)] = v;
  }
};

/// Kinetic energy at step 20, relative to that at the start, and whether the run ends there.
std::optional<Failure> with_energy_ratio(double bound, double ratio, int at_step = 20) {
  Body body;
  body.set_speed(1);
  body.control.energy_bound = bound;
  const auto integrator = integrator_that([&](State<2>& state) {
    if (state.step == at_step) body.set_speed(std::sqrt(ratio));
    if (state.step == at_step + 1) body.set_speed(1);
  });
  return run(body.solid, body.state, integrator, body.control).failure;
}

TEST(RunBounds, EnergyMayGrowByTheBoundAndNoMore) {
  EXPECT_FALSE(with_energy_ratio(0.5, 1.49));
  const auto failure = with_energy_ratio(0.5, 1.51);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->cause, Cause::energy_growth);
  EXPECT_EQ(failure->step, 20);
  EXPECT_NEAR(failure->time, 20e-4, 1e-15);
  EXPECT_FALSE(failure->particle);
  Body body;
  double mass = 0;
  for (const double V : body.solid.cloud.V) mass += 1100 * V;
  EXPECT_NEAR(failure->value.value(), 1.51 * mass / 2, 1e-9 * mass);
  EXPECT_EQ(failure->quantity, "total energy");
  EXPECT_FALSE(with_energy_ratio(0.5, 1.51, 7));  // looked at every twenty steps
}

TEST(RunBounds, ABodyAtRestMayHaveTheRoundOffOfItsEnergy) {
  for (const double share : {0.9, 1.1}) {  // of twice the bound of round-off
    Body body;
    body.control.energy_bound = 1;
    double mass = 0;
    for (const double V : body.solid.cloud.V) mass += 1100 * V;
    const double speed = std::sqrt(2 * share * 2 * energy_round_off(body.solid) / mass);
    const auto result =
        run(body.solid, body.state, integrator_that([&](State<2>&) { body.set_speed(speed); }), body.control);
    EXPECT_EQ(result.failure.has_value(), share > 1) << share;
  }
}

TEST(RunBounds, InitialEnergyIsThatOfTheHistoryIfThereIsOne) {
  for (const double initial :
       {1.0, 3.0}) {  // relative to that of the start: growth to 2.5 is too much for one of them
    Body body;
    body.set_speed(1);
    body.control.energy_bound = 1;
    RunRecord history;
    history.initial_energy = initial * energy_of(body.solid, body.state).total();
    const auto integrator = integrator_that([&](State<2>&) { body.set_speed(std::sqrt(2.5)); });
    const auto result = run<2>(body.solid, body.state, integrator, body.control, {}, history);
    EXPECT_EQ(result.failure.has_value(), initial == 1.0);
  }
}

TEST(RunBounds, HourglassShareMayReachItsBoundAndNoMore) {
  Body body;
  const double d = body.solid.cloud.spacing;
  const auto wobble = [&](State<2>& state, double size) {
    for (Index i = 0; i < body.solid.cloud.size(); ++i) {
      const Vec<2>& X = body.solid.cloud.X[i];
      const bool odd = (std::lround(X[0] / d - 0.5) + std::lround(X[1] / d - 0.5)) % 2;
      state.u[0][body.solid.bonds.slots.of(i)] = (odd ? 1 : -1) * size * d;
    }
  };
  wobble(body.state, 0.05);
  const double share = hourglass_share(body.solid, body.state);
  for (const double bound : {0.99 * share, 1.01 * share}) {
    body.state = make_state(body.solid);
    body.control.hourglass_bound = bound;
    const auto result =
        run(body.solid, body.state, integrator_that([&](State<2>& s) { wobble(s, 0.05); }), body.control);
    ASSERT_EQ(result.failure.has_value(), bound < share);
    if (!result.failure) continue;
    EXPECT_EQ(result.failure->cause, Cause::hourglass);
    EXPECT_NEAR(result.failure->value.value(), share, 1e-12);
    EXPECT_EQ(result.failure->step, 20);
  }
}

TEST(RunBounds, ATimeStepThatCollapsesEndsTheRun) {
  for (const double share : {0.9e-3, 1.1e-3}) {  // of the first step, with the default of 1e-3
    Body body;
    body.control.fixed_step.reset();
    body.control.cfl = 0.5;
    const Index one = body.solid.bonds.slots.of(0), next = body.solid.bonds.slots.of(1);
    const Vec<2> apart = body.solid.cloud.X[1] - body.solid.cloud.X[0];
    const auto result =
        run(body.solid, body.state, integrator_that([&](State<2>& state) {
              if (state.step == 3)
                set_vector<2>(state.u, one, (1 - share) * apart + vector_at<2>(state.u, next));
            }),
            body.control);
    ASSERT_EQ(result.failure.has_value(), share < 1e-3) << share;
    if (!result.failure) continue;
    EXPECT_EQ(result.failure->cause, Cause::time_step_collapse);
    EXPECT_EQ(result.failure->step, 3);
    EXPECT_NEAR(result.failure->value.value(), share * result.dt.first, 1e-12 * result.dt.first);
  }
}

TEST(RunBounds, StepsAreCountedAndTheLastIsCutToTheEnd) {
  Body body;
  body.control.max_steps.reset();
  body.control.end_time = 3.5e-4;
  std::vector<double> times;
  const auto result =
      run<2>(body.solid, body.state, integrator_that([](State<2>&) {}), body.control,
             [&](const Solid<2>&, const State<2>& s) { return times.push_back(s.time), true; });
  ASSERT_EQ(times.size(), 5u);  // the start and four steps
  EXPECT_EQ(times.front(), 0);
  EXPECT_DOUBLE_EQ(times.back(), 3.5e-4);
  EXPECT_TRUE(result.completed());
  EXPECT_DOUBLE_EQ(result.dt.first, 1e-4);
  EXPECT_DOUBLE_EQ(result.dt.last, 1e-4);  // the cut step says nothing about stability
  EXPECT_DOUBLE_EQ(result.dt.least, 1e-4);
}

TEST(RunBounds, StatisticsKeepFirstLeastMostAndLast) {
  StepStatistics dt;
  for (const double step : {3.0, 2.0, 5.0, 4.0}) dt.count(step);
  EXPECT_EQ(dt.first, 3);
  EXPECT_EQ(dt.least, 2);
  EXPECT_EQ(dt.most, 5);
  EXPECT_EQ(dt.last, 4);
}

TEST(RunBounds, MaxStepsAndObserversEndARun) {
  Body body;
  body.control.max_steps = 7;
  EXPECT_TRUE(run(body.solid, body.state, integrator_that([](State<2>&) {}), body.control).completed());
  EXPECT_EQ(body.state.step, 7);
  const auto result =
      run<2>(body.solid, body.state = make_state(body.solid), integrator_that([](State<2>&) {}), body.control,
             [](const Solid<2>&, const State<2>& s) { return s.step < 3; });
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.completed());
  EXPECT_EQ(body.state.step, 3);
}

TEST(Causes, HaveTheirNames) {
  EXPECT_EQ(name_of(Cause::non_finite), "non-finite");
  EXPECT_EQ(name_of(Cause::inverted), "inverted");
  EXPECT_EQ(name_of(Cause::energy_growth), "energy-growth");
  EXPECT_EQ(name_of(Cause::time_step_collapse), "time-step-collapse");
  EXPECT_EQ(name_of(Cause::hourglass), "hourglass");
}

}  // namespace
}  // namespace plumb::testing
