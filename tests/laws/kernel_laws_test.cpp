// Every kernel of the catalogue, in 1D, 2D and 3D, keeps the laws of THEORY chapter 1.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <numbers>

#include "lib/kernel/kernel.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

/// Integral over [0, support], piecewise between the multiples of 1/2, where splines have their knots.
template <class F>
double integral(double support, F f) {
  double sum = 0;
  for (int half = 0; 0.5 * half < support - 1e-12; ++half)
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        f, 0.5 * half, std::min(0.5 * (half + 1), support), 5, 1e-14);
  return sum;
}

/// Surface of the unit sphere in d dimensions.
template <int d>
constexpr double surface = d == 1   ? 2
                           : d == 2 ? 2 * std::numbers::pi
                                    : 4 * std::numbers::pi;

template <class K>
constexpr bool has_cusp() {
  if constexpr (requires { K::cusp; })
    return K::cusp;
  else
    return false;
}

template <class Case>
class KernelLaws : public ::testing::Test {};
TYPED_TEST_SUITE(KernelLaws, test::AllDimensions<KernelCatalogue>, test::Names);

/// THEORY (1.1).
TYPED_TEST(KernelLaws, UnitIntegral) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const double total =
      surface<d> * integral(K::support, [](double q) { return K::template w<d>(q) * std::pow(q, d - 1); });
  EXPECT_NEAR(total, 1, 1e-13);  // round-off of some hundred terms
}

TYPED_TEST(KernelLaws, SlopeIsTheDerivative) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const auto w = [](double q) { return K::template w<d>(q); };
  const double s = 1e-3;
  for (int n = 0; 0.0137 + 0.0291 * n < K::support; ++n) {
    const double q = 0.0137 + 0.0291 * n;
    const double to_knot = std::abs(q - 0.5 * std::round(2 * q));
    if (to_knot < 2.5 * s) continue;  // differences must not reach over a knot
    const double difference = (8 * (w(q + s) - w(q - s)) - (w(q + 2 * s) - w(q - 2 * s))) / (12 * s);
    // fourth order: s^4 w'''''/30 < 1e-10 w(0) for |w'''''| < 3000 w(0); round-off 1e-16/s is smaller
    EXPECT_NEAR(K::template dw<d>(q), difference, 1e-10 * w(0)) << "q = " << q;
  }
  const double drop = integral(K::support, [](double q) { return K::template dw<d>(q); });
  EXPECT_NEAR(drop, -w(0), 1e-13 * w(0));  // no piece is missing between the sampled points
}

TYPED_TEST(KernelLaws, CompactAndContinuousAtTheEdge) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  for (const double q : {1.0, 1 + 1e-15, 1.1, 2.0, 1e6}) {
    EXPECT_EQ(K::template w<d>(q * K::support), 0);
    EXPECT_EQ(K::template dw<d>(q * K::support), 0);
  }
  EXPECT_NEAR(K::template w<d>(K::support - 1e-9), 0, 1e-8);  // at most first order in the distance
  EXPECT_GT(K::template w<d>(0.98 * K::support), 0);          // the support is not declared larger than it is
}

TYPED_TEST(KernelLaws, PositiveAndFalling) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  for (int n = 1; n < 99 * K::support; ++n) {
    const double q = 0.01 * n;
    EXPECT_GT(K::template w<d>(q), 0) << q;
    EXPECT_LT(K::template dw<d>(q), 0) << q;
  }
}

TYPED_TEST(KernelLaws, FlatAtTheCentreUnlessItDeclaresACusp) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  if (has_cusp<K>()) {
    EXPECT_LT(K::template dw<d>(0), 0);
  } else {
    EXPECT_EQ(K::template dw<d>(0), 0);
  }
}

TYPED_TEST(KernelLaws, IsFoundByItsName) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  static_assert(Kernel<K, d>);
  const RadialKernel<d> found = kernel_named<d>(K::name);
  EXPECT_EQ(found.support, K::support);
  for (const double q : {0.0, 0.3, 1.2, 1.9}) {  // tells two kernels with the same name apart
    EXPECT_EQ(found.w(q), K::template w<d>(q));
    EXPECT_EQ(found.dw(q), K::template dw<d>(q));
  }
}

}  // namespace
}  // namespace plumb
