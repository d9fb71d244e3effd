// Bodies of the scheme of paper 001 that spin, break, fail or meet a wall.
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

/// Kinetic energy, and all works, of a plate that falls aslant on a rough floor: equal to round-off at every step.
TEST(EulerianBodies, OnAWallTheWorksAddUpToTheKineticEnergy) {
  const Cloud<2> cloud = cells<2>({8, 6}, 0.1);
  RigidWall<2> wall;
  wall.beside = half_space<2>(Vec<2>(0, -0.31), Vec<2>(0, 1));
  wall.modulus = 2e6;
  wall.friction = 0.2;
  wall.reach = 0.05;
  wall.displacement = [](double t) { return Vec<2>(0, 0.3 * t); };
  for (const char* force : {"adjoint", "printed"}) {
    EulerianOptions o;
    o.force = force;
    Eulerian<2> body({cloud, LawChoice("linear-elastic"), {2e6, 0.3, 1000}}, o, {}, 5, {wall});
    auto state = body.start(moving<2>(cloud, [](const Vec<2>& X) { return Vec<2>(1, -2 + X[0]); }));
    const double before = body.energy(state).kinetic;
    double most = 0;
    for (int step = 0; step < 120; ++step) {
      ASSERT_FALSE(body.advance(state, 5e-4));
      double outside = 0;
      for (const auto& [by, done] : body.outside().named(state.outside)) outside += done;
      const double now = body.energy(state).kinetic, scale = before + now + std::abs(state.work.force);
      ASSERT_NEAR((now - before - state.work.of_forces() - outside) / scale, 0, 1e-13) << step;
      most = std::max(most, std::abs(state.outside.contact));
    }
    EXPECT_EQ(body.outside().named(state.outside).size(), 2u);
    EXPECT_GT(most, 0.2 * before);
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
