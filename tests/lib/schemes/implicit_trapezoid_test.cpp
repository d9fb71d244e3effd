// The trapezoidal rule: what it is where forces are linear, its order, and what it keeps.
#include "lib/schemes/implicit/trapezoid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/convergence/order_fit.hpp"
#include "lib/schemes/implicit/midpoint.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// Turns at 30 rad/s and stretches.
BodyMotion turning(const Solid<2>& solid) {
  BodyMotion motion{VectorXd::Zero(2 * solid.cloud.size()), VectorXd(2 * solid.cloud.size()), 0, 0};
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<2>& X = solid.cloud.X[i];
    motion.v.segment<2>(2 * i) = Vec<2>(-30 * X[1] + 10 * X[0] + 1, 30 * X[0]);
  }
  return motion;
}

template <class Rule>
BodyMotion moved(const Solid<2>& solid, const Actions<2>& actions, BodyMotion motion, int steps, double dt) {
  Rule rule(stored_energy(solid), actions, 1e-13, motion);
  for (int n = 0; n < steps; ++n) EXPECT_TRUE(rule.step(motion, dt).converged()) << n;
  return motion;
}

Eigen::Vector3d momenta(const Solid<2>& solid, const BodyMotion& motion) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<2> x = solid.cloud.X[i] + motion.u.segment<2>(2 * i), v = motion.v.segment<2>(2 * i);
    sum += solid.elastic.density * solid.cloud.V[i] * Eigen::Vector3d(v[0], v[1], x[0] * v[1] - x[1] * v[0]);
  }
  return sum;
}

const Actions<2> nothing;

/// Of linear forces both ends have twice the middle's, so that the rules are one.
TEST(Trapezoid, IsTheMidpointRuleOfLinearForces) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("linear-elastic"), 0, 0, 4);
  Actions<2> pushed;
  pushed.body_forces.push_back(
      {"push", [](const Vec<2>& X, double t) { return Vec<2>(1e4 * X[1] * t, 2e3); }, false});
  const BodyMotion start = turning(solid), one = moved<Trapezoid<2>>(solid, pushed, start, 12, 1e-3),
                   other = moved<Midpoint<2>>(solid, pushed, start, 12, 1e-3);
  EXPECT_LT((one.u - other.u).norm(), 1e-10 * other.u.norm());
  EXPECT_LT((one.v - other.v).norm(), 1e-10 * other.v.norm());
  EXPECT_EQ(one.step, 12);
  EXPECT_NEAR(one.time, 0.012, 1e-15);
}

TEST(Trapezoid, IsOfSecondOrder) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  const auto after = [&](int steps) {
    return moved<Trapezoid<2>>(solid, nothing, turning(solid), steps, 0.008 / steps).u;
  };
  const VectorXd exact = moved<Midpoint<2>>(solid, nothing, turning(solid), 1280, 0.008 / 1280).u;
  std::vector<Level> levels;
  for (const int steps : {10, 20, 40, 80})
    levels.push_back({0.008 / steps, (after(steps) - exact).norm() / exact.norm()});
  const OrderFit fit = fit_order(levels);
  EXPECT_NEAR(fit.order, 2, 0.1) << fit.lower << " " << fit.upper;
}

/// Linear momentum to the tolerance; of the angular momentum an error that falls with the square of the step, the midpoint's is none.
TEST(Trapezoid, KeepsLinearMomentumAndTheAngularOneToSecondOrder) {
  const Solid<2> solid = testing::elastic_body<2>({"compatible"}, LawChoice("neo-hookean"), 0.5, 0.2, 4);
  const Eigen::Vector3d before = momenta(solid, turning(solid));
  double drift[2];
  for (const int n : {0, 1}) {
    const int steps = 100 << n;  // coarser ones do not resolve the shortest waves
    const Eigen::Vector3d after =
        momenta(solid, moved<Trapezoid<2>>(solid, nothing, turning(solid), steps, 0.02 / steps));
    EXPECT_LT((after - before).head<2>().norm(), 1e-10 * before.head<2>().norm());
    drift[n] = std::abs(after[2] - before[2]) / before[2];
  }
  EXPECT_GT(drift[1], 1e-7);  // it is there, so that the ratio means something
  EXPECT_NEAR(std::log2(drift[0] / drift[1]), 2, 0.05);
}

/// Supports end where they are told to; a body whose J is not positive at the start is named as such.
TEST(Trapezoid, FollowsSupportsAndRefusesABodyTurnedInsideOut) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0, 4);
  const Actions<2> pulled = holding<2>(solid.cloud, {{0, 0, 0.5}, {3, 1, 0.0}});
  BodyMotion motion{VectorXd::Zero(2 * solid.cloud.size()), VectorXd::Zero(2 * solid.cloud.size()), 0, 0};
  motion.v[0] = 0.5;
  motion = moved<Trapezoid<2>>(solid, pulled, motion, 10, 1e-3);
  EXPECT_NEAR(motion.u[0], 0.005, 1e-15);
  EXPECT_NEAR(motion.v[0], 0.5, 1e-12);
  EXPECT_EQ(motion.u[7], 0);
  BodyMotion inside_out = motion;
  for (Index i = 0; i < solid.cloud.size(); ++i) inside_out.u[2 * i] = -2 * solid.cloud.X[i][0];
  Trapezoid<2> rule(stored_energy(solid), nothing, 1e-12, inside_out);
  const BodyMotion before = inside_out;
  EXPECT_EQ(rule.step(inside_out, 1e-3).end, NewtonEnd::inverted);
  EXPECT_EQ(inside_out.u, before.u);
}

}  // namespace
}  // namespace plumb
