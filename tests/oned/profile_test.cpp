// The correction along the body, the function itself, waves and operators: against exact rational arithmetic and closed forms.
#include "oned/profile.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lib/core/error.hpp"
#include "oned/explorer.hpp"
#include "oned/function.hpp"
#include "oned/response.hpp"
#include "tests/oned/second_derivation.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;
using second::Rational;

/// dx = 1, R = 4, 16 particles.
Discretisation sixteen_particles(double radius = 4) {
  Discretisation d;
  d.length = 16;
  d.n = 16;
  d.radius.value = radius;
  return d;
}

TEST(Profile, IsThatOfRationalArithmetic) {
  const auto cloud = second::cell_cloud<Rational>(16);
  const std::vector<Rational> places{0, Rational(1, 4), Rational(3, 2), 8, 16};
  std::vector<double> at;
  for (const Rational& x : places) at.push_back(static_cast<double>(x));
  const auto rows = correction_profile(sixteen_particles(), at);
  ASSERT_EQ(rows.size(), at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    SCOPED_TRACE(at[k]);
    const auto plain = second::weights<Rational>(cloud, places[k], second::Kernel::cubic, Rational(2), -1);
    const auto first = second::weights<Rational>(cloud, places[k], second::Kernel::cubic, Rational(2), 1);
    Rational sum = 0, negative = 0, m1 = 0, m2 = 0;
    for (std::size_t j = 0; j < cloud.X.size(); ++j) {
      const Rational s = (cloud.X[j] - places[k]) / 4;
      sum += plain.w[j], m1 += plain.w[j] * s, m2 += plain.w[j] * s * s;
      if (first.w[j] < 0) negative -= first.w[j];
    }
    Eigen::Matrix2d moments;
    moments << static_cast<double>(sum), static_cast<double>(m1), static_cast<double>(m1),
        static_cast<double>(m2);
    const Eigen::Vector2d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(moments).eigenvalues();
    constexpr double digits = 1e-12;  // sums of nine terms, and a condition below 100
    const ProfileRow& row = rows[k];
    EXPECT_EQ(row.x, at[k]);
    EXPECT_NEAR(row.alpha, static_cast<double>(first.alpha), digits * row.alpha);
    EXPECT_NEAR(row.beta, static_cast<double>(first.beta), digits * 10);
    EXPECT_NEAR(row.VW, static_cast<double>(sum), digits);
    EXPECT_NEAR(row.VW0, 1, digits);
    EXPECT_NEAR(row.VW1, 1, digits);
    EXPECT_NEAR(row.negative, static_cast<double>(negative), digits);
    EXPECT_NEAR(row.condition, eigenvalues[1] / eigenvalues[0], 100 * digits * row.condition);
  }
  EXPECT_GT(rows[0].negative, 0.2);  // at the wall the first-order kernel is no mean
  EXPECT_EQ(rows[3].negative, 0);
}

TEST(Profile, RefusesPlacesOutsideAndTooManyPoints) {
  EXPECT_THROW(correction_profile(sixteen_particles(), {-0.1}), InputError);
  EXPECT_THROW(correction_profile(sixteen_particles(), {16.1}), InputError);
  EXPECT_THROW(even_points(1, 1), InputError);
  EXPECT_EQ(even_points(2, 5), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
}

/// The curves go through the particles.
TEST(KernelCurves, AreTheKernelsAtTheParticles) {
  const Discretisation d = sixteen_particles();
  const KernelView view = explore(d, 0.75);
  const KernelCurves curves = kernel_curves(d, view, 20);  // every 1/4 from 0 to 4.75
  ASSERT_EQ(curves.s.size(), 20u);
  int seen = 0;
  for (std::size_t k = 0; k < curves.s.size(); ++k)
    for (const KernelRow& row : view.rows)
      if (std::abs(row.x - curves.s[k]) < 1e-12) {
        EXPECT_NEAR(curves.W[k], row.W, 1e-14);
        EXPECT_NEAR(curves.W0[k], row.W0, 1e-14);
        EXPECT_NEAR(curves.W1[k], row.W1, 1e-14);
        ++seen;
      }
  EXPECT_EQ(seen, 5);  // 1/2, 3/2, .., 9/2
}

/// Constants by all but the plain kernel, lines by the first order; the wall has half of the plain sum at x = 0.
TEST(Function, IsExactUpToTheOrderOfItsKernel) {
  const auto error = [](const char* field, Correction pair) {
    double largest = 0;
    for (const auto& row : function_rows(sixteen_particles(), {parse_field(field)}, {pair}))
      largest = std::max(largest, std::abs(row.error));
    return largest;
  };
  EXPECT_LT(error("poly:3", Correction::W0), 1e-14);
  EXPECT_LT(error("poly:3,2", Correction::W1), 1e-13);
  EXPECT_GT(error("poly:3", Correction::none), 0.9);
  EXPECT_GT(error("poly:3,2", Correction::W0), 0.1);
  // X^2 inside: sum V W (X_j - X)^2 = m2 = h^2/3 of the cubic spline, a B-spline whose sums are its integrals
  const auto rows = function_rows(sixteen_particles(), {parse_field("poly:0,0,1")}, {Correction::W1});
  EXPECT_NEAR(rows[8].error, 4.0 / 3, 1e-12);
}

TEST(Resolution, OfTheCentralDifference) {  // sin(theta)/theta = 0.99 and 0.9
  const auto found = resolutions("cubic", 1.8, {{"standard", Correction::W1}}, {0.01, 0.1});
  ASSERT_EQ(found.size(), 2u);
  for (const Resolution& one : found) {
    ASSERT_TRUE(one.theta);
    EXPECT_NEAR(std::sin(*one.theta) / *one.theta, 1 - one.error, 1e-13);
    EXPECT_NEAR(*one.particles_per_wave * *one.theta, 2 * std::numbers::pi, 1e-12);
  }
}

TEST(Resolution, OfAnOperatorThatIsOffForLongWaves) {  // the uncorrected bond estimate of a line is 2/3
  const auto found = resolutions("cubic", 4, {{"bond", Correction::W1}}, {0.01});
  EXPECT_FALSE(found[0].theta);
  EXPECT_FALSE(found[0].particles_per_wave);
}

TEST(SameOperators, StandardAndImprovedBelowTwoSpacings) {
  const std::vector<GradientMethod> methods{
      {"standard", Correction::W1}, {"bond", Correction::W1}, {"improved", Correction::W1}};
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(same_operators("cubic", 1.8, methods), (Pairs{{0, 2}}));
  EXPECT_EQ(same_operators("cubic", 4, methods), Pairs{});
}

}  // namespace
