// The implicit midpoint rule: momenta, order, and what it is exact for.
#include "lib/schemes/implicit/midpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/convergence/order_fit.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// A free block that turns at 30 rad/s and stretches.
template <int d>
State<d> spinning(const Solid<d>& solid) {
  State<d> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    Vec<d> v = Vec<d>::Zero();
    const Vec<d>& X = solid.cloud.X[i];
    v[0] = -30 * X[1] + 10 * X[0] + 1;
    v[1] = 30 * X[0];
    set_vector<d>(state.v, solid.bonds.slots.of(i), v);
  }
  return state;
}

template <int d>
void momenta_stay() {
  const Solid<d> solid = testing::elastic_body<d>({"compatible"}, LawChoice("neo-hookean"), 0.5, 0.2, 4);
  State<d> state = spinning(solid);
  const Actions<d> nothing;
  Midpoint<d> midpoint(solid, nothing, 1e-13, state);
  const Momentum before = momentum_of(solid, state);
  const double energy = energy_of(solid, state).total();
  for (int n = 0; n < 40; ++n) ASSERT_TRUE(midpoint.step(state, 2e-3).converged()) << n;
  const Momentum after = momentum_of(solid, state);
  EXPECT_EQ(state.step, 40);
  EXPECT_NEAR(state.time, 0.08, 1e-15);
  // 40 steps, each exact to 1e-13 of its forces
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(after.linear[k], before.linear[k], 1e-11 * before.linear_scale);
    EXPECT_NEAR(after.angular[k], before.angular[k], 1e-11 * before.angular_scale);
  }
  EXPECT_GT(std::abs(before.angular[2]), 0.1 * before.angular_scale);
  EXPECT_NEAR(energy_of(solid, state).total(), energy, 0.05 * energy);
  EXPECT_GT(energy_of(solid, state).strain, 1e-3 * energy);  // it does deform
}

TEST(Midpoint, KeepsBothMomenta) {
  momenta_stay<2>();
  momenta_stay<3>();
}

TEST(Midpoint, IsOfSecondOrder) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  const Actions<2> nothing;
  const auto after = [&](int steps) -> VectorXd {
    State<2> state = spinning(solid);
    Midpoint<2> midpoint(solid, nothing, 1e-13, state);
    for (int n = 0; n < steps; ++n) EXPECT_TRUE(midpoint.step(state, 0.008 / steps).converged());
    return unknowns_of(solid, state.u);
  };
  const VectorXd exact = after(1280);  // an error of 1/256 of the finest below
  std::vector<Level> levels;
  for (const int steps : {10, 20, 40, 80})
    levels.push_back({0.008 / steps, (after(steps) - exact).norm() / exact.norm()});
  const OrderFit fit = fit_order(levels);
  EXPECT_NEAR(fit.order, 2, 0.1) << fit.lower << " " << fit.upper;
}

/// Free fall from rest in one step, and supports that end where they are told to, exactly.
TEST(Midpoint, FollowsConstantLoadsAndSupports) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  Actions<2> gravity;
  gravity.body_forces.push_back(
      {"gravity", [](const Vec<2>&, double) { return Vec<2>(0, -10 * 1100); }, true});
  State<2> state = make_state(solid);
  Midpoint<2> midpoint(solid, gravity, 1e-13, state);
  ASSERT_TRUE(midpoint.step(state, 0.2).converged());
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Index slot = solid.bonds.slots.of(i);
    EXPECT_NEAR(state.u[1][slot], -10 * 0.02, 1e-12);
    EXPECT_NEAR(state.v[1][slot], -10 * 0.2, 1e-11);
  }
  Actions<2> pulled = holding<2>(solid.cloud, {{0, 0, 0.5}, {3, 1, 0.0}});
  state = make_state(solid);
  state.v[0][solid.bonds.slots.of(0)] = 0.5;
  Midpoint<2> moved(solid, pulled, 1e-12, state);
  for (int n = 0; n < 10; ++n) ASSERT_TRUE(moved.step(state, 1e-3).converged());
  EXPECT_NEAR(state.u[0][solid.bonds.slots.of(0)], 0.005, 1e-15);
  EXPECT_NEAR(state.v[0][solid.bonds.slots.of(0)], 0.5, 1e-12);
  EXPECT_EQ(state.u[1][solid.bonds.slots.of(3)], 0);
}

/// A force that grows with time, taken at the middle of the step, gives its whole impulse.
TEST(Midpoint, TakesLoadsAtTheMiddleOfTheStep) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  Actions<2> growing;
  growing.body_forces.push_back(
      {"growing", [](const Vec<2>&, double t) { return Vec<2>(1100 * 6 * t, 0); }, false});
  State<2> state = make_state(solid);
  Midpoint<2> midpoint(solid, growing, 1e-10, state);
  for (int n = 0; n < 2; ++n) ASSERT_TRUE(midpoint.step(state, 0.1).converged());
  EXPECT_NEAR(state.v[0][solid.bonds.slots.of(0)], 3 * 0.04, 1e-9);
}

TEST(Midpoint, AStepThatFailsLeavesTheState) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  Actions<2> lost;
  lost.body_forces.push_back({"lost",
                              [](const Vec<2>&, double t) -> Vec<2> {
                                return {std::sqrt(1.5e-3 - t), 0};
                              },
                              false});
  State<2> state = spinning(solid);
  Midpoint<2> midpoint(solid, lost, 1e-12, state);
  ASSERT_TRUE(midpoint.step(state, 1e-3).converged());
  const VectorXd u = unknowns_of(solid, state.u);
  const NewtonResult result = midpoint.step(state, 2e-3);
  EXPECT_EQ(result.end, NewtonEnd::not_a_number);
  EXPECT_EQ(unknowns_of(solid, state.u), u);
  EXPECT_EQ(state.step, 1);
  EXPECT_EQ(state.time, 1e-3);
}

}  // namespace
}  // namespace plumb
