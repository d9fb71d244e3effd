// Bodies of the scheme of paper 001 that spin, break or fail.
#include <gtest/gtest.h>
#include <omp.h>

#include "lib/schemes/point_fields.hpp"
#include "tests/support/eulerian.hpp"

namespace plumb::testing {
namespace {

/// Kinetic energy that is left and radius of gyration over the first, of a square of 10 x 10 that spins at 0.11 c_p, after
/// 1000 steps.
struct Spun {
  double kinetic, radius, spin;
};
Spun spun(const std::string& force, const std::string& damping) {
  const Cloud<2> cloud = cells<2>({10, 10}, 0.1);
  EulerianOptions o;
  o.force = force;
  o.damping = damping;
  auto body = eulerian_body<2>(cloud, o);
  auto state = body.start(turning<2>(cloud, 0.11 * body.wave_speed() / 0.5));
  const BodySums<2> before = body_sums<2>(body.snapshot(state));
  const double kinetic = body.energy(state).kinetic;
  advance_by(body, state, 1000);
  const BodySums<2> after = body_sums<2>(body.snapshot(state));
  return {body.energy(state).kinetic / kinetic, std::sqrt(after.inertia / before.inertia),
          after.spin / before.spin};
}

TEST(EulerianBodies, ASpinningPlateIsInflatedByExtrapolatedVelocitiesOnly) {
  const Spun objective = spun("adjoint", "objective"), extrapolated = spun("adjoint", "extrapolated"),
             printed = spun("printed", "extrapolated");
  EXPECT_NEAR(objective.spin, 1, 1e-12);  // a thousand steps of round-off
  EXPECT_GT(objective.kinetic, 0.98);
  EXPECT_NEAR(objective.radius, 1, 0.02);  // stretched by its spin
  EXPECT_LT(extrapolated.kinetic, objective.kinetic - 0.02);
  EXPECT_GT(extrapolated.radius, objective.radius + 0.01);
  EXPECT_GT(std::abs(printed.spin - 1), 1e-6);
}

TEST(EulerianBodies, AFragmentIsCountedAndBearsNothing) {
  const Cloud<2> cloud = cells<2>({8, 8}, 0.1);
  for (const char* force : {"adjoint", "printed"}) {
    EulerianOptions o;
    o.force = force;
    auto body = eulerian_body<2>(cloud, o);
    auto state = body.start({});
    EXPECT_EQ(body.singular(), 0);
    // two particles far away: their neighbours lie on a line, which no gradient spans
    for (const Index i : {0L, 1L}) set_vector<2>(state.u, i, Vec<2>(-3, -3));
    ASSERT_FALSE(body.advance(state, 1e-6));
    EXPECT_EQ(body.singular(), 2);
    for (Index i = 0; i < cloud.size(); ++i) {
      ASSERT_TRUE(vector_at<2>(state.acceleration, i).allFinite());
      if (i < 2) {
        EXPECT_EQ(state.density[0][i], soft.density);
      }
    }
  }
}

TEST(EulerianBodies, AFailedParticleIsNotGluedToItsNeighbours) {
  const Cloud<2> cloud = cells<2>({8, 8}, 0.1);
  const LawChoice law("johnson-cook", {{"yield", 1e5}, {"damage_1", 1}});
  Eulerian<2> body({cloud, law, soft}, EulerianOptions{}, {});
  const auto motion = rough_motion<2>(cloud);
  auto state = body.start({{}, motion.v});
  const Index k = nearest<2>(cloud, Vec<2>(0.05, 0.05));
  ASSERT_FALSE(body.advance(state, 1e-4));
  EXPECT_GT(vector_at<2>(state.hourglass, k).norm(), 0);
  for (Index i = 0; i < cloud.size(); ++i) state.plastic[3][i] = i == k ? 1 : 0;
  ASSERT_FALSE(body.advance(state, 1e-4));
  EXPECT_EQ(vector_at<2>(state.hourglass, k).norm(), 0);
  EXPECT_EQ(tensor_at<2>(state.stress, k).norm(), 0);
  double others = 0;
  for (Index i = 0; i < cloud.size(); ++i) others = std::max(others, vector_at<2>(state.hourglass, i).norm());
  EXPECT_GT(others, 0);
  const Snapshot<2> shown = body.snapshot(state);
  for (const auto& more : shown.more)
    if (more.name == "damage") {
      EXPECT_EQ(more.values[k], 1);
    }
}

TEST(EulerianBodies, SameBitsForOneAndTwoThreads) {
  const Cloud<2> cloud = cells<2>({40, 40}, 0.05);
  const int threads = omp_get_max_threads();
  std::vector<EulerianState<2>> ends;
  for (const int n : {1, 2}) {
    omp_set_num_threads(n);
    auto body = eulerian_body<2>(cloud, EulerianOptions{});
    ends.push_back(body.start(rough_motion<2>(cloud)));
    advance_by(body, ends.back(), 3);
  }
  omp_set_num_threads(threads);
  for (Index i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(vector_at<2>(ends[0].u, i), vector_at<2>(ends[1].u, i)) << i;
    ASSERT_EQ(tensor_at<2>(ends[0].stress, i), tensor_at<2>(ends[1].stress, i)) << i;
  }
  EXPECT_EQ(ends[0].work.stress, ends[1].work.stress);
}

}  // namespace
}  // namespace plumb::testing
