#include "lib/schemes/tlsph/measures/solid_measures.hpp"

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

/// Energy of a body that is turned as a whole: nothing but round-off.
template <int d>
double energy_of_a_turn(const Solid<d>& solid, double angle) {
  State<d> state = make_state(solid);
  Mat<d> turn = Mat<d>::Identity();
  turn(0, 0) = turn(1, 1) = std::cos(angle);
  turn(1, 0) = std::sin(angle);
  turn(0, 1) = -turn(1, 0);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i), turn * solid.cloud.X[i] - solid.cloud.X[i]);
  return energy_of(solid, state).strain;
}

template <int d>
void expect_a_bound(const std::string& material, double jitter, double size) {
  Cloud<d> cloud = testing::block<d>(8, Layout::node, jitter);
  for (auto& X : cloud.X) X *= size;
  for (auto& V : cloud.V) V *= std::pow(size, d);
  cloud.spacing *= size;
  const auto options = testing::options<d>({}, cloud.spacing);
  const Elastic rubber{17e6, 0.4999, 1100};
  const Solid<d> solid = make_solid<d>(std::move(cloud), material, rubber, options);
  double most = 0;
  for (int n = 0; n < 60; ++n) most = std::max(most, std::abs(energy_of_a_turn(solid, 0.1 * n)));
  EXPECT_LT(most, energy_round_off(solid)) << material << ' ' << d << 'D';
  EXPECT_GT(most, energy_round_off(solid) / 200) << material << ' ' << d << "D: the bound says nothing";
}

// THEORY (8.9), whatever the unit of length.
TEST(EnergyRoundOff, OfABodyThatIsOnlyTurnedIsWithinItsBound) {
  for (const char* material : {"neo-hookean", "mooney-rivlin"})
    for (const double jitter : {0.0, 0.2})
      for (const double size : {1e-6, 1.0, 1e6}) {
        expect_a_bound<2>(material, jitter, size);
        expect_a_bound<3>(material, jitter, size);
      }
}

}  // namespace
}  // namespace plumb
