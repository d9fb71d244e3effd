// What acts from outside, on total Lagrangian bodies: values from mechanics, for both integrators.
#include "lib/schemes/tlsph/boundary/apply_actions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/geometry/facets.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/measures/budget.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

constexpr double area_of_end = 0.8;  // of rubber_block<2>(5): 1 x 0.8 m

template <int d>
BodyForce<d> body_force(const Vec<d>& value, bool steady) {
  return {"body force", [value](const Vec<d>&, double) { return value; }, steady};
}

/// The pieces of one face, by its outward normal.
template <int d>
std::vector<LoadedPlace<d>> places_on(const Cloud<d>& cloud, const Vec<d>& normal) {
  std::vector<LoadedPlace<d>> places;
  for (const Facet<d>& facet : box_facets(cloud))
    if (facet.area.dot(normal) > 0.99 * facet.area.norm())
      places.push_back({facet.owner, facet.centroid, facet.area});
  return places;
}

/// The actions of one evaluation of the forces [N/m^d], particle by particle, without the body's own.
template <int d>
std::vector<Vec<d>> forces_of(Solid<d>& solid, State<d>& state, const Actions<d>& actions) {
  const auto evaluated = [&](Solid<d> body) {
    std::vector<Vec<d>> f(static_cast<std::size_t>(body.bonds.slots.count()));
    Workspace<d> workspace;
    EXPECT_TRUE(evaluate(body, workspace, state, state.time, [&](const Block& block, BlockForce<d>& force) {
      for (Index i = block.begin(); i < block.end(); ++i)
        for (int k = 0; k < d; ++k) f[static_cast<std::size_t>(i)][k] = force(k, i);
    }));
    std::vector<Vec<d>> by_particle;
    for (Index i = 0; i < body.cloud.size(); ++i)
      by_particle.push_back(f[static_cast<std::size_t>(body.bonds.slots.of(i))]);
    return by_particle;
  };
  const auto without = evaluated(solid);
  Solid<d> loaded = solid;
  apply_actions(loaded, actions);
  auto with = evaluated(loaded);
  for (std::size_t i = 0; i < with.size(); ++i) with[i] -= without[i];
  return with;
}

class Loads : public ::testing::TestWithParam<std::string> {};

TEST_P(Loads, AFreeBodyFallsAsGalileiSays) {
  const Vec<2> g(0.3, -9.81);
  for (const bool steady : {true, false}) {
    Solid<2> solid = rubber_block<2>(5, Layout::node, 0.1);
    Actions<2> actions;
    actions.body_forces.push_back(body_force<2>(solid.elastic.density * g, steady));
    apply_actions(solid, actions);
    State<2> state = make_state(solid);
    StepControl control;
    control.cfl = 0.4;
    control.end_time = 0.02;
    ASSERT_TRUE(run(solid, state, integrator_named<2>(GetParam(), solid), control).completed());
    for (Index i = 0; i < solid.cloud.size(); ++i) {
      const Index slot = solid.bonds.slots.of(i);
      // nothing strains the body, so only the rounding of some 50 steps is left
      EXPECT_LT((vector_at<2>(state.v, slot) - 0.02 * g).norm(), 1e-12 * g.norm());
      EXPECT_LT((vector_at<2>(state.u, slot) - 0.5 * 0.02 * 0.02 * g).norm(), 1e-12 * g.norm());
    }
  }
}

// A constant load is integrated exactly by both: the momentum is the impulse, and a held end takes up its
// share.
TEST_P(Loads, TheBudgetOfALoadedAndHeldBodyClosesToRoundOff) {
  Solid<2> solid = rubber_block<2>(5, Layout::node, 0);
  Actions<2> actions;
  std::vector<Support<2>> left;
  for (const Index i : particles_on_face(solid.cloud, 0, false, Layout::node))
    for (int k = 0; k < 2; ++k) left.push_back({i, k, 0});
  actions = holding(solid.cloud, left);
  actions.body_forces.push_back(body_force<2>(Vec<2>(0, -2e5), true));
  actions.surface.push_back(
      {"right",
       places_on<2>(solid.cloud, Vec<2>(1, 0)),
       [](const Vec<2>&, const Vec<2>&, double t) { return Vec<2>(1e5 * std::cos(900 * t), 3e4); },
       {},
       false});
  actions.surface.push_back(
      {"top", places_on<2>(solid.cloud, Vec<2>(0, 1)), {}, [](const Vec<2>&, double) { return 2e5; }, true});
  apply_actions(solid, actions);
  State<2> state = make_state(solid);
  impose(solid, actions, state);
  const ChosenIntegrator<2> integrator = integrator_named<2>(GetParam(), solid);
  Budget<2> budget(solid, state, integrator.weights);
  StepControl control;
  control.cfl = 0.3;
  control.max_steps = 40;
  ASSERT_TRUE(run<2>(solid, state, integrator, control, [&](const Solid<2>& body, const State<2>& now) {
                if (now.step > 0) budget.close_step(body, now);
                return true;
              }).completed());
  EXPECT_LT(budget.total().linear_gap, 1e-13);  // sums of 30 particles, 40 steps
  EXPECT_LT(budget.total().angular_gap, 1e-13);
  EXPECT_LT(budget.total().energy_gap, 1e-12);
  const Vec<3> weight(0, -2e5 * area_of_end * state.time, 0);
  const BudgetPart& loads = budget.total().part("loads");
  // the vertical part of the pressure's force and of the traction on top of the weight: bounded by their
  // sizes
  EXPECT_LT((loads.linear - weight)[1], 3e4 * area_of_end * state.time);
  EXPECT_GT(loads.energy, 0);                              // the loads pull the body down and to the right
  EXPECT_EQ(budget.total().part("supports").energy, 0.0);  // what does not move does no work
}

INSTANTIATE_TEST_SUITE_P(Integrators, Loads, ::testing::Values("rk3", "verlet"),
                         [](const auto& tested) { return tested.param; });

TEST(Loads, ATractionActsWithItsAreaWhateverTheDeformation) {
  for (const Layout layout : {Layout::node, Layout::cell}) {
    Solid<3> solid = rubber_block<3>(4, layout, 0);
    State<3> state = make_state(solid);
    deform(solid, state, 0.05);
    const Vec<3> t(3e4, -1e4, 2e4);
    Actions<3> actions;
    actions.surface.push_back({"top",
                               places_on<3>(solid.cloud, Vec<3>(0, 0, 1)),
                               [&](const Vec<3>&, const Vec<3>&, double) { return t; },
                               {},
                               true});
    Vec<3> sum = Vec<3>::Zero();
    const auto f = forces_of(solid, state, actions);
    for (Index i = 0; i < solid.cloud.size(); ++i) sum += solid.cloud.V[i] * f[static_cast<std::size_t>(i)];
    const double area = solid.cloud.box.size[0] * solid.cloud.box.size[1];
    EXPECT_LT((sum - area * t).norm(), 1e-11 * area * t.norm());  // differences of forces 1e3 times larger
  }
}

// Nanson: under x = F X a face of area A and normal N has the area vector cof F N A. F is exact for affine
// motion.
TEST(Loads, APressureFollowsTheSurface) {
  Solid<3> solid = rubber_block<3>(4, Layout::node, 0);
  Mat<3> F;
  F << 1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.15, 0.1, 1.1;
  State<3> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<3>(state.u, solid.bonds.slots.of(i), (F - Mat<3>::Identity()) * solid.cloud.X[i]);
  const double p = 5e4;
  Vec<3> all = Vec<3>::Zero();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const Vec<3> N = side * Vec<3>::Unit(axis);
      Actions<3> actions;
      actions.surface.push_back(
          {"face", places_on<3>(solid.cloud, N), {}, [&](const Vec<3>&, double) { return p; }, true});
      Vec<3> sum = Vec<3>::Zero();
      const auto f = forces_of(solid, state, actions);
      for (Index i = 0; i < solid.cloud.size(); ++i) sum += solid.cloud.V[i] * f[static_cast<std::size_t>(i)];
      const double area = solid.cloud.box.size.prod() / solid.cloud.box.size[axis];
      const Vec<3> exact = -p * area * F.determinant() * (F.inverse().transpose() * N);
      EXPECT_LT((sum - exact).norm(), 1e-9 * exact.norm())
          << N.transpose();  // differences of forces 1e5 times larger
      all += sum;
    }
  EXPECT_LT(all.norm(), 1e-9 * p);  // a closed surface under one pressure has no resultant
}

// Prescribed paths are exact at the end of every step, and RK3 keeps its order with them (the accelerations
// are seen at the times of the stages).
TEST(PrescribedMotion, IsExactAfterEveryStepAndKeepsTheOrder) {
  const auto end_state = [](int steps) {
    Solid<2> solid = rubber_block<2>(4, Layout::node, 0);
    Held<2> held;
    held.name = "right";
    held.steady = false;
    held.motion = [](const Vec<2>& at, int k, double t) -> HeldMotion {
      const double a = 0.01 * (k + 1) * at[0], w = 800;
      return {a * std::sin(w * t), a * w * std::cos(w * t), -a * w * w * std::sin(w * t)};
    };
    for (const Index i : particles_on_face(solid.cloud, 0, true, Layout::node))
      for (int k = 0; k < 2; ++k) held.places.push_back({i, k, solid.cloud.X[i]});
    Actions<2> actions;
    actions.held.push_back(held);
    State<2> state = make_state(solid);
    impose(solid, actions, state);
    apply_actions(solid, actions);
    const ChosenIntegrator<2> integrator = with_prescribed_motion(integrator_named<2>("rk3", solid), actions);
    for (int n = 0; n < steps; ++n) EXPECT_TRUE(integrator.step(solid, state, 2e-3 / steps));
    for (const auto& place : held.places) {
      const Index slot = solid.bonds.slots.of(place.particle);
      const HeldMotion exact = held.motion(place.at, place.component, state.time);
      EXPECT_EQ(state.u[place.component][slot], *exact.displacement);
      EXPECT_EQ(state.v[place.component][slot], exact.velocity);
    }
    return vector_at<2>(state.u, solid.bonds.slots.of(6));
  };
  const Vec<2> coarse = end_state(20), middle = end_state(40), fine = end_state(80);
  EXPECT_NEAR(std::log2((coarse - middle).norm() / (middle - fine).norm()), 3, 0.3);  // the next term
}

}  // namespace
}  // namespace plumb::testing
