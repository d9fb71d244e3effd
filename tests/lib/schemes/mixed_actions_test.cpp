// What acts from outside on a body of the scheme of paper 003, against mechanics.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/geometry/facets.hpp"
#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

const Vec<2> gravity(0.3, -9.81);

TEST(MixedActions, AFreeBodyFallsAsGalileiSays) {
  for (const bool steady : {true, false}) {
    Actions<2> actions;
    actions.body_forces.push_back(
        {"weight", [](const Vec<2>&, double) -> Vec<2> { return column_rubber.density * gravity; }, steady});
    Mixed<2> body = mixed_body(cube<2>(4), MixedOptions(), actions);
    MixedState<2> state = body.start({});
    ASSERT_TRUE(run_to(body, state, 0.02));
    const Snapshot<2> s = body.snapshot(state);
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      EXPECT_LT((s.v[i] - 0.02 * gravity).norm(), 1e-12);
      EXPECT_LT((s.x[i] - s.X[i] - 0.0002 * gravity).norm(), 1e-13);
    }
  }
}

// The stages see the loads at t, t + dt, t + dt/2: with weights 1/6, 1/6, 2/3 a cubic in time is exact.
TEST(MixedActions, LoadsAreTakenAtTheTimesOfTheStages) {
  Actions<2> actions;
  actions.body_forces.push_back({"push",
                                 [](const Vec<2>&, double t) -> Vec<2> {
                                   return {1.1e15 * t * t * t, 0};
                                 },
                                 false});
  Mixed<2> body = mixed_body(cube<2>(3), MixedOptions(), actions);
  MixedState<2> state = body.start({});
  for (int n = 0; n < 4; ++n) ASSERT_FALSE(body.advance(state, 5e-4));
  EXPECT_NEAR(body.snapshot(state).v[5][0], 4, 1e-12);
}

/// A load on the upper face of a unit square.
template <class Load>
Actions<2> on_top(const Cloud<2>& cloud, Load&& set) {
  SurfaceLoad<2> load;
  load.name = "top";
  for (const Facet<2>& facet : box_facets(cloud))
    if (facet.area[1] > 0.99 * facet.area.norm())
      load.places.push_back({facet.owner, facet.centroid, facet.area});
  set(load);
  Actions<2> actions;
  actions.surface.push_back(load);
  return actions;
}

/// Force on a body in that motion [N].
Vec<2> force_on(const Cloud<2>& cloud, const Actions<2>& actions, const InitialMotion<2>& motion) {
  Mixed<2> body = mixed_body(cloud, MixedOptions(), actions);
  const MixedState<2> state = body.start(motion);
  MixedState<2> rate = state;
  EXPECT_FALSE(body.rates(state, 0.5, rate));
  Vec<2> sum = Vec<2>::Zero();
  for (Index p = 0; p < cloud.size(); ++p)
    sum += column_rubber.density * cloud.V[p] * vector_at<2>(rate.v, body.bonds().table.slots.of(p));
  return sum;
}

TEST(MixedActions, TractionsKeepTheirDirectionAndPressuresFollow) {
  const Cloud<2> cloud = cube<2>(4);
  InitialMotion<2> motion;
  for (const Vec<2>& X : cloud.X)
    motion.u.push_back({0.5 * X[0], 0.2 * X[0] + 0.1 * X[1]});  // F = 1.5 0, .2 1.1
  const auto traction = on_top(cloud, [](SurfaceLoad<2>& load) {
    load.traction = [](const Vec<2>&, const Vec<2>& normal, double t) -> Vec<2> {
      return {3 * t, 100 * normal[1]};
    };
  });
  const double round_off = 1e-6;  // of stresses of 1e7 Pa
  const Vec<2> dead = force_on(cloud, traction, motion);
  EXPECT_NEAR(dead[0], 1.5, round_off);
  EXPECT_NEAR(dead[1], 100, round_off);
  const auto pressure = on_top(
      cloud, [](SurfaceLoad<2>& load) { load.pressure = [](const Vec<2>&, double t) { return 200 * t; }; });
  const Vec<2> follows = force_on(cloud, pressure, motion);  // -p cof(F) N, cof F N = (-.2, 1.5)
  EXPECT_NEAR(follows[0], 20, round_off);
  EXPECT_NEAR(follows[1], -150, round_off);
}

/// Holds all components of the lower edge, and moves the upper one.
template <class Motion>
Actions<2> pulled(const Cloud<2>& cloud, Motion&& upper) {
  Held<2> still{"bottom", {}, [](const Vec<2>&, int, double) { return HeldMotion{}; }};
  Held<2> moves{"top", {}, upper, false};
  for (Index p = 0; p < cloud.size(); ++p)
    for (int k = 0; k < 2; ++k) {
      if (cloud.X[p][1] < -0.49) still.places.push_back({p, k, cloud.X[p]});
      if (cloud.X[p][1] > 0.49) moves.places.push_back({p, k, cloud.X[p]});
    }
  Actions<2> actions;
  actions.held = {still, moves};
  return actions;
}

TEST(MixedActions, HeldComponentsAreWhereTheyAreToldToBe) {
  const Cloud<2> cloud = cube<2>(4);
  const auto path = [](const Vec<2>& X, int k, double t) -> HeldMotion {
    const double a = k == 0 ? 0.02 * (1 + X[0]) : 0.01;
    return {a * std::sin(40 * t), 40 * a * std::cos(40 * t), -1600 * a * std::sin(40 * t)};
  };
  for (const bool smooth : {false, true}) {
    MixedOptions o;
    o.smooth_positions = smooth;
    Mixed<2> body = mixed_body(cloud, o, pulled(cloud, path));
    MixedState<2> state = body.start({});
    EXPECT_EQ(body.snapshot(state).v[cloud.size() - 1][1], 0.4);  // from the start
    ASSERT_TRUE(run_to(body, state, 0.02));
    const Snapshot<2> s = body.snapshot(state);
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (s.X[i][1] < -0.49) {
        EXPECT_EQ(s.x[i], s.X[i]);
      }
      if (s.X[i][1] > 0.49) {
        EXPECT_EQ(s.x[i][0], s.X[i][0] + 0.02 * (1 + s.X[i][0]) * std::sin(40 * state.time));
        EXPECT_EQ(s.v[i][1], 0.4 * std::cos(40 * state.time));
      }
    }
  }
}

// Where only the velocity is prescribed the displacement follows from the same stages: third order.
TEST(MixedActions, DisplacementsFollowFromPrescribedVelocities) {
  const Cloud<2> cloud = cube<2>(3);
  const auto error = [&](int steps) {
    Mixed<2> body =
        mixed_body(cloud, MixedOptions(), pulled(cloud, [](const Vec<2>&, int k, double t) -> HeldMotion {
                     return {std::nullopt, k * std::cos(600 * t), -600.0 * k * std::sin(600 * t)};
                   }));
    MixedState<2> state = body.start({});
    for (int n = 0; n < steps; ++n) EXPECT_FALSE(body.advance(state, 4e-3 / steps));
    const Snapshot<2> s = body.snapshot(state);
    const std::size_t top = static_cast<std::size_t>(cloud.size() - 1);
    return std::abs(s.x[top][1] - s.X[top][1] - std::sin(2.4) / 600);
  };
  EXPECT_GT(std::log2(error(8) / error(16)), 2.8);
}

/// The values that a snapshot shows under that name.
std::vector<double> shown(const Snapshot<2>& snapshot, const std::string& name) {
  for (const NamedValues& more : snapshot.more)
    if (more.name == name) return more.values;
  ADD_FAILURE() << name << " is not shown";
  return {};
}

// One step of homogeneous shear of .1 from rest: the values of paper 003's copper (Hencky plasticity).
TEST(MixedPlasticity, HistoryIsCommittedOnceWithTheEndOfTheStep) {
  const Elastic copper{117e9, 0.35, 8930};
  const LawChoice law("j2-logarithmic", {{"yield", 0.4e9}, {"hardening", 0.1e9}});
  const Cloud<2> cloud = cube<2>(3);
  Held<2> all{"all", {}, [](const Vec<2>& X, int k, double) {
                return HeldMotion{std::nullopt, k == 0 ? X[1] : 0};
              }};
  for (Index p = 0; p < cloud.size(); ++p)
    for (int k = 0; k < 2; ++k) all.places.push_back({p, k, cloud.X[p]});
  Actions<2> actions;
  actions.held = {all};
  for (const char* upwind : {"none", "adjoint"}) {
    Mixed<2> body = mixed_body(cloud, mixed_options(upwind), actions, law, copper);
    MixedState<2> state = body.start({});
    ASSERT_FALSE(body.advance(state, 0.1));
    const Snapshot<2> s = body.snapshot(state);
    for (const double strain : shown(s, "plastic strain")) EXPECT_NEAR(strain, 0.0545920806956853, 1e-13);
    // sigma = P F^T / 1: sigma_12 = P_12 + P_13 0 + .. = P_11 F_21 + P_12 F_22
    EXPECT_NEAR(s.cauchy[4](0, 1), 233799915.458275, 1);
    EXPECT_NEAR(s.cauchy[4](0, 0), -11689995.772914 + 0.1 * 233799915.458275, 1);
  }
}

TEST(MixedPlasticity, NothingFlowsBackOnUnloading) {
  const Elastic copper{117e9, 0.35, 8930};
  const LawChoice law("j2-logarithmic", {{"yield", 0.4e9}, {"hardening", 0.1e9}});
  const Cloud<2> cloud = cube<2>(4);
  MixedOptions o;
  o.cfl = 0.05;  // the work errs by the first power of the step
  Mixed<2> body = mixed_body(cloud, o, {}, law, copper);
  MixedState<2> state = body.start({{}, rough_motion(cloud, 0, 300).v});
  std::vector<double> before(cloud.X.size(), 0.0);
  double most = 0;
  const double E0 = body.energy(state).total();
  for (int n = 0; n < 400; ++n) {
    ASSERT_FALSE(body.advance(state, body.step_limit(state)));
    const std::vector<double> now = shown(body.snapshot(state), "plastic strain");
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_GE(now[i], before[i]);
      most = std::max(most, now[i]);
    }
    before = now;
  }
  EXPECT_GT(most, 1e-3);
  // kinetic and elastic energy, plastic work and heat; the work is that of the stress at the end of each step
  const Energy energy = body.energy(state);
  ASSERT_EQ(energy.more.size(), 1U);
  EXPECT_EQ(energy.more[0].name, "plastic work");
  EXPECT_GT(energy.more[0].value, 0.1 * E0);
  EXPECT_NEAR(energy.total() + *energy.dissipated, E0, 0.05 * E0);
}

}  // namespace
}  // namespace plumb::testing
