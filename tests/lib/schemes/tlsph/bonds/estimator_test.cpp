// The estimators against their printed form and against exact facts.
#include "lib/schemes/tlsph/bonds/estimator.hpp"

#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

/// The improved estimate literally as printed: (33) at the particle, (39) for each pair, (37) to sum. The
/// oracle.
template <int d>
Mat<d> pairwise(const std::vector<Vec<d>>& X, const std::vector<Vec<d>>& x, const Vec<d>& Xi,
                const Vec<d>& xi, const CorrectedKernel<d>& k) {
  Mat<d> Fi = Mat<d>::Zero();
  for (std::size_t j = 0; j < X.size(); ++j) Fi += (x[j] - xi) * k.gradient[j].transpose();
  Mat<d> Fc = Mat<d>::Zero();
  for (std::size_t j = 0; j < X.size(); ++j) {
    const double r = (X[j] - Xi).norm();
    Mat<d> Fij = Fi;
    if (r > 0) {
      const Vec<d> e = (X[j] - Xi) / r;
      Fij = Fi - (Fi * e) * e.transpose() + (x[j] - xi) / r * e.transpose();
    }
    Fc += k.weight[j] * Fij;
  }
  return Fc;
}

template <int d>
void expect_equal_to_pairwise(const Cloud<d>& cloud, Correction pair, double beta) {
  const auto kernel = kernel_named<d>("cubic");
  const double h = beta * cloud.spacing;
  test::Numbers numbers(3);
  std::vector<Vec<d>> moved;  // a random deformation: no symmetry, no smoothness
  for (const auto& X : cloud.X) moved.push_back(1.3 * X + 0.5 * cloud.spacing * numbers.vector<d>());
  for (Index i = 0; i < cloud.size(); ++i) {
    std::vector<Index> numbers_of;
    const auto neighbours = test::neighbours_of<d>(cloud, cloud.X[i], 2 * h, &numbers_of);
    const auto k = correct<d>(pair, kernel, h, neighbours);
    const auto c = Improved::stencil<d>(neighbours, k);
    std::vector<Vec<d>> X, x;
    for (const Index j : numbers_of) {
      X.push_back(cloud.X[j]);
      x.push_back(moved[j]);
    }
    const Mat<d> oracle = pairwise<d>(X, x, cloud.X[i], moved[i], k);
    Mat<d> F = Mat<d>::Zero();
    double scale = 0;  // size of the terms: W1 has negative weights, so that terms cancel
    for (std::size_t j = 0; j < c.size(); ++j) {
      F += (x[j] - moved[i]) * c[j].transpose();
      scale += (x[j] - moved[i]).norm() * c[j].norm();
    }
    ASSERT_LT((F - oracle).norm(), 1e-13 * scale) << "particle " << i << ", beta " << beta;
  }
}

template <class Case>
class ImprovedStencil : public ::testing::Test {};
TYPED_TEST_SUITE(ImprovedStencil, test::AllDimensions<TypeList<test::Plain>>, test::Names);

TYPED_TEST(ImprovedStencil, IsTheLiteralPairwiseForm) {
  constexpr int d = TypeParam::d;
  for (const auto& [name, cloud] : test::all_clouds<d>())
    for (const double beta : {0.9, 1.5})
      for (const Correction pair : {Correction::none, Correction::W0raw, Correction::W0, Correction::W1}) {
        SCOPED_TRACE(name + ", " + std::string(name_of(pair)));
        expect_equal_to_pairwise<d>(cloud, pair, beta);
      }
}

/// Estimated gradient of x = X at particle i of a cloud.
template <class E, int d>
Mat<d> gradient_of_identity(const Cloud<d>& cloud, Index i, Correction pair, double h) {
  const auto neighbours = test::neighbours_of<d>(cloud, cloud.X[i], 2 * h);
  const auto c =
      E::template stencil<d>(neighbours, correct<d>(pair, kernel_named<d>("cubic"), h, neighbours));
  Mat<d> F = Mat<d>::Zero();
  for (std::size_t j = 0; j < c.size(); ++j) F += neighbours[j].separation * c[j].transpose();
  return F;
}

Cloud<1> line_of_cells() {
  return lattice<1>({Vec<1>(0), Vec<1>(5)}, {40}, Layout::cell);
}

// Exact fractions of an independent calculation: R = 4 dx, tolerance is round-off.
TEST(Bond, FailsOnALinearField) {
  const Cloud<1> cloud = line_of_cells();
  const double h = 2 * cloud.spacing;
  const auto at = [&](Index i) { return gradient_of_identity<Bond, 1>(cloud, i, Correction::W1, h)(0, 0); };
  EXPECT_NEAR(at(20), 2.0 / 3, 1e-13);
  EXPECT_NEAR(at(0), 71.0 / 583, 1e-13);
}

// One minus W(0) V: interior of a 2D lattice, cubic spline, W1 (2.1): weights sum to one, each bond gives e
// (x) e, and by symmetry F_xx = (1 - w_ii) / 2 + w_ii. Rounded values; the expression is exact.
TEST(Bond38, FailsOnTheIdentityIn2D) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), {2.2, 2.2}}, {11, 11}, Layout::cell);
  const auto expect = [&](double beta, double rounded) {
    const double h = beta * cloud.spacing;
    const Mat<2> F = gradient_of_identity<Bond38, 2>(cloud, 60, Correction::W1, h);
    double sum = 0;  // of V W over the neighbourhood, by its own loop
    for (const auto& X : cloud.X)
      sum += cloud.V[60] * CubicSpline::w<2>((X - cloud.X[60]).norm() / h) / (h * h);
    const double own = cloud.V[60] * CubicSpline::w<2>(0) / (h * h) / sum;
    EXPECT_NEAR(F(0, 0), 0.5 * (1 + own), 1e-13) << beta;
    EXPECT_NEAR(F(0, 0), rounded, 5.1e-3) << beta;  // two printed digits
    EXPECT_NEAR(F(0, 1), 0, 1e-13);
  };
  expect(0.9, 0.78);
  expect(1.2, 0.66);
  expect(1.5, 0.60);
}

/// Derivative of x(X) at particle i of the line, by the estimator.
template <class E, class Field>
double slope(const Cloud<1>& cloud, Index i, Correction pair, double h, Field field) {
  std::vector<Index> numbers;
  const auto neighbours = test::neighbours_of<1>(cloud, cloud.X[i], 2 * h, &numbers);
  const auto c =
      E::template stencil<1>(neighbours, correct<1>(pair, kernel_named<1>("cubic"), h, neighbours));
  double sum = 0;
  for (std::size_t j = 0; j < c.size(); ++j)
    sum += (field(cloud.X[numbers[j]][0]) - field(cloud.X[i][0])) * c[j][0];
  return sum;
}

// X^3: f''' = 6, so the interior errors are 2/3 and 4/9 of 6 dx^2, exactly (no higher derivative).
TEST(InteriorError, OfACubicFieldAtFourSpacings) {
  const Cloud<1> cloud = line_of_cells();
  const double dx = cloud.spacing, X = cloud.X[20][0];
  const auto cube = [](double x) { return x * x * x; };
  const double standard = slope<Standard>(cloud, 20, Correction::W1, 2 * dx, cube) - 3 * X * X;
  const double improved = slope<Improved>(cloud, 20, Correction::W1, 2 * dx, cube) - 3 * X * X;
  EXPECT_NEAR(standard / (6 * dx * dx), 2.0 / 3, 1e-10);  // round-off 1e-16 * 20 / dx^2
  EXPECT_NEAR(improved / (6 * dx * dx), 4.0 / 9, 1e-10);
}

// X^2 at the first particle, in units of f'' dx: exact fractions of an independent calculation.
TEST(BoundaryError, OfAQuadraticFieldAtFourSpacings) {
  const Cloud<1> cloud = line_of_cells();
  const double dx = cloud.spacing, X = cloud.X[0][0];
  const auto square = [](double x) { return x * x; };
  const auto error = [&]<class E>(Type<E>, Correction pair) {
    return (slope<E>(cloud, 0, pair, 2 * dx, square) - 2 * X) / (2 * dx);
  };
  EXPECT_NEAR(error(Type<Standard>{}, Correction::W1), 267780.0 / 339889, 1e-12);
  EXPECT_NEAR(error(Type<Improved>{}, Correction::W1), 0.691899, 5e-7);  // six digits are known
  EXPECT_NEAR(error(Type<Improved>{}, Correction::W0), 8291.0 / 9664, 1e-12);
  EXPECT_NEAR(error(Type<Standard>{}, Correction::W0), 160.0 / 151, 1e-12);
}

// Any arrangement: with (5b) the improved error on a quadratic is V_i W1_ii times the standard one.
TEST(BoundaryError, ImprovedIsTheOwnWeightTimesTheStandardOne) {
  const Cloud<1> cloud = jittered<1>(line_of_cells(), 0.3, 5, Layout::cell);
  const auto square = [](double x) { return x * x; };
  for (Index i = 0; i < cloud.size(); ++i)
    for (const double reach : {1.6, 2.0}) {
      const double h = reach * cloud.spacing, exact = 2 * cloud.X[i][0];
      const auto neighbours = test::neighbours_of<1>(cloud, cloud.X[i], 2 * h);
      const auto k = correct<1>(Correction::W1, kernel_named<1>("cubic"), h, neighbours);
      double own = 0;
      for (std::size_t j = 0; j < neighbours.size(); ++j)
        if (neighbours[j].separation[0] == 0) own = k.weight[j];
      const double standard = slope<Standard>(cloud, i, Correction::W1, h, square) - exact;
      const double improved = slope<Improved>(cloud, i, Correction::W1, h, square) - exact;
      EXPECT_NEAR(improved, own * standard, 1e-11)
          << i;  // values up to 25, differences over dx: 1e-15 * 25 / 0.1
    }
}

// R = 1.8 dx: on uniform particles both estimators are the central difference, in the interior.
TEST(Improved, IsTheStandardOneAtBetaNineTenths) {
  const Cloud<1> cloud = line_of_cells();
  const auto wave = [](double x) { return std::sin(5 * x); };
  const double dx = cloud.spacing, X = cloud.X[20][0];
  const double central = (wave(X + dx) - wave(X - dx)) / (2 * dx);
  EXPECT_NEAR(slope<Standard>(cloud, 20, Correction::W1, 0.9 * dx, wave), central, 1e-12);
  EXPECT_NEAR(slope<Improved>(cloud, 20, Correction::W1, 0.9 * dx, wave), central, 1e-12);
  for (Index i = 0; i < 3; ++i)  // and the same operator at the boundary
    EXPECT_NEAR(slope<Improved>(cloud, i, Correction::W1, 0.9 * dx, wave),
                slope<Standard>(cloud, i, Correction::W1, 0.9 * dx, wave), 1e-12);
}

}  // namespace
}  // namespace plumb
