#include "lib/schemes/tlsph/boundary/supports.hpp"

#include <gtest/gtest.h>

#include "lib/schemes/tlsph/boundary/apply_actions.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

TEST(Faces, HoldTheFirstLayerOfEveryLayout) {
  for (const Layout layout : {Layout::cell, Layout::node})
    for (const double jitter : {0.0, 0.2}) {
      const Cloud<3> cloud = block<3>(6, layout, jitter);  // 6 x 5 x 4 cells
      const auto one = static_cast<std::size_t>(layout == Layout::node ? 1 : 0);
      EXPECT_EQ(particles_on_face(cloud, 0, false, layout).size(), (5 + one) * (4 + one));
      EXPECT_EQ(particles_on_face(cloud, 1, true, layout).size(), (6 + one) * (4 + one));
      EXPECT_EQ(particles_on_face(cloud, 2, true, layout).size(), (6 + one) * (5 + one));
    }
}

TEST(Supports, HeldComponentsMoveAsPrescribedAndTheOthersAreFree) {
  for (const std::string& integrator : names_of(IntegratorCatalogue{})) {
    Solid<2> solid = rubber_block<2>(10, Layout::node, 0);
    const auto left = particles_on_face(solid.cloud, 0, false, Layout::node);
    const auto right = particles_on_face(solid.cloud, 0, true, Layout::node);
    std::vector<Support<2>> supports;
    supports.reserve(left.size() + right.size());
    for (const Index i : left) supports.push_back({i, 0, 0.0});   // roller
    for (const Index i : right) supports.push_back({i, 0, 3.0});  // pulled
    State<2> state = make_state(solid);
    const Actions<2> actions = holding(solid.cloud, supports);
    apply_actions(solid, actions);
    impose(solid, actions, state);
    StepControl control;
    control.cfl = 0.4;
    control.max_steps = 60;
    ASSERT_TRUE(run(solid, state, integrator_named<2>(integrator, solid), control).completed());
    double sideways = 0;
    for (const Index i : left) {
      EXPECT_EQ(state.u[0][solid.bonds.slots.of(i)], 0.0);
      sideways = std::max(sideways, std::abs(state.u[1][solid.bonds.slots.of(i)]));
    }
    for (const Index i : right)  // 60 steps of rounding
      EXPECT_NEAR(state.u[0][solid.bonds.slots.of(i)], 3.0 * state.time, 1e-13 * 3.0 * state.time);
    EXPECT_GT(sideways, 0);  // a roller lets go along the face
  }
}

}  // namespace
}  // namespace plumb::testing
