#include "plumbline/diagnostics/measures.hpp"

#include <gtest/gtest.h>

#include "tests/support/solids.hpp"

namespace plumb {
namespace {

using testing::rubber_block;

/// Displacement size * X^2 along the first axis.
State<2> quadratic(const Solid<2>& solid, double size) {
  State<2> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<2>(state.u, solid.bonds.slots.of(i),
                  Vec<2>(size * solid.cloud.X[i][0] * solid.cloud.X[i][0], 0));
  return state;
}

// THEORY (8.4): the mean of the two gradients explains a quadratic field exactly where they are exact, that
// is inside; one of them alone misses size d^2 on each bond along the axis, which are half of the bonds.
TEST(HourglassShare, AQuadraticFieldIsExplainedButForTheBoundary) {
  const double size = 1e-3;
  const Solid<2> solid = rubber_block<2>(40, Layout::node, 0);
  const double d = solid.cloud.spacing, one_sided = size * d * d / (d * std::sqrt(2.0));
  EXPECT_LT(hourglass_share(solid, quadratic(solid, size)), 0.25 * one_sided);
}

TEST(HourglassShare, AnAlternatingMotionIsNotExplained) {
  const Solid<2> solid = rubber_block<2>(20, Layout::node, 0);
  State<2> state = make_state(solid);
  const double d = solid.cloud.spacing, size = 0.01 * d;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<2>& X = solid.cloud.X[i];
    const bool odd = (std::lround(X[0] / d) + std::lround(X[1] / d)) % 2;
    set_vector<2>(state.u, solid.bonds.slots.of(i), Vec<2>(odd ? size : -size, 0));
  }
  // F does not see it inside, so that each bond misses 2 size of its length d
  EXPECT_NEAR(hourglass_share(solid, state), 0.02, 0.002);
}

}  // namespace
}  // namespace plumb
