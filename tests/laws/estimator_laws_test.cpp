// Every gradient estimator of the catalogue: its table gives the gradient of an affine map exactly at every
// particle of every cloud, unless it declares that it does not. THEORY chapter 3.
#include <gtest/gtest.h>

#include "lib/schemes/tlsph/bonds/estimator.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

template <class E, int d>
constexpr bool is_affine() {
  if constexpr (requires { E::template affine<d>; })
    return E::template affine<d>;
  else
    return true;
}

template <class Case>
class EstimatorLaws : public ::testing::Test {};
TYPED_TEST_SUITE(EstimatorLaws, test::AllDimensions<EstimatorCatalogue>, test::Names);

TYPED_TEST(EstimatorLaws, AffineMapsAreExactOrTheTypeSaysNo) {
  using E = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  test::Numbers numbers(11);
  const Mat<d> A = Mat<d>::Identity() + 0.4 * numbers.matrix<d>();
  double worst = 0;
  for (const auto& [name, cloud] : test::all_clouds<d>())
    for (const auto kernel : {kernel_named<d>("cubic"), kernel_named<d>("wendland-c2")})
      for (const double beta : {0.9, 1.5})
        for (const Correction pair : {Correction::W0, Correction::W1})
          for (Index i = 0; i < cloud.size(); ++i) {
            const double h = beta * cloud.spacing;
            const auto neighbours = test::neighbours_of<d>(cloud, cloud.X[i], kernel.support * h);
            const auto c = E::template stencil<d>(neighbours, correct<d>(pair, kernel, h, neighbours));
            Mat<d> F = Mat<d>::Zero();
            for (std::size_t j = 0; j < c.size(); ++j) F += A * neighbours[j].separation * c[j].transpose();
            worst = std::max(worst, (F - A).norm() / A.norm());
          }
  if (is_affine<E, d>()) {
    EXPECT_LT(worst, 1e-12);  // as the conditions (9a), (9b) themselves
  } else {
    EXPECT_GT(worst, 0.1);  // the failure is of order 1, and known
  }
}

TYPED_TEST(EstimatorLaws, OwnEntryIsZero) {
  using E = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::small_lattice<d>(Layout::node);
  const auto kernel = kernel_named<d>("cubic");
  const auto neighbours = test::neighbours_of<d>(cloud, cloud.X[0], 0.36);
  const auto c = E::template stencil<d>(neighbours, correct<d>(Correction::W1, kernel, 0.18, neighbours));
  ASSERT_EQ(c.size(), neighbours.size());
  for (std::size_t j = 0; j < c.size(); ++j)
    if (neighbours[j].separation.norm() == 0) {
      EXPECT_EQ(c[j].norm(), 0);
    }
}

TYPED_TEST(EstimatorLaws, IsFoundByItsName) {
  using E = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  static_assert(Estimator<E, d>);
  EXPECT_EQ(estimator_named<d>(E::name), &E::template stencil<d>);
}

}  // namespace
}  // namespace plumb
