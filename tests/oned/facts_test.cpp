// The exact facts about the 1D estimates with the cubic spline each derived a second
// time in exact rational arithmetic and compared with what oned/ computes.
#include <gtest/gtest.h>

#include "oned/explorer.hpp"
#include "oned/gradient.hpp"
#include "oned/response.hpp"
#include "tests/oned/second_derivation.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;
using second::Rational;

// Sums of at most 9 terms of size 1 to 10: some units in the last place. 1e-12 is the digits asked for.
constexpr double tolerance = 1e-12;

/// dx = 1, R = 4, 16 particles: both ends and an interior without cut supports.
Discretisation unit_lattice(double radius = 4) {
  Discretisation d;
  d.length = 16;
  d.n = 16;
  d.radius.value = radius;
  return d;
}

std::vector<double> estimates(const std::string& field, const std::string& estimator, Correction pair,
                              double radius = 4) {
  std::vector<double> values;
  for (const auto& row : gradient_rows(unit_lattice(radius), {parse_field(field)}, {{estimator, pair}}))
    values.push_back(row.value);
  return values;
}

struct Exact {
  second::Cloud<Rational> cloud = second::cell_cloud<Rational>(16);
  std::vector<Rational> X2, X3, linear;
  Exact() {
    for (const Rational& X : cloud.X) {
      linear.emplace_back(X + 1);
      X2.emplace_back(X * X);
      X3.emplace_back(X * X * X);
    }
  }
  second::Weights<Rational> at(std::size_t i, int order, bool L = false) const {
    auto w = second::weights<Rational>(cloud, cloud.X[i], second::Kernel::cubic, Rational(2), order);
    if (L) second::normalise(w, cloud, cloud.X[i]);
    return w;
  }
};

constexpr std::size_t middle = 8;

TEST(Facts, BondOfALinearFieldInside) {
  const Exact exact;
  EXPECT_EQ(second::bond(exact.at(middle, 1), exact.cloud, middle, exact.linear), Rational(2, 3));
  EXPECT_NEAR(estimates("poly:1,1", "bond", Correction::W1)[middle], 2.0 / 3, tolerance);
}

TEST(Facts, BondOfALinearFieldAtTheFirstParticle) {
  const Exact exact;
  EXPECT_EQ(second::bond(exact.at(0, 1), exact.cloud, 0, exact.linear), Rational(71, 583));
  EXPECT_NEAR(estimates("poly:1,1", "bond", Correction::W1).front(), 71.0 / 583, tolerance);
}

TEST(Facts, InteriorErrorOfACubicField) {
  const Exact exact;
  // x = X^3: f''' = 6, so the errors are 6 * 2/3 and 6 * 4/9 (times dx^2 = 1)
  const Rational derivative = 3 * exact.cloud.X[middle] * exact.cloud.X[middle];
  EXPECT_EQ(Rational(second::standard(exact.at(middle, 1), exact.X3) - derivative), Rational(4));
  EXPECT_EQ(Rational(second::improved(exact.at(middle, 1), exact.cloud, middle, exact.X3) - derivative),
            Rational(8, 3));
  const double ours = 3 * 8.5 * 8.5;
  // values of X^3 reach 2197 inside the support: 2200 eps = 5e-13 per term
  EXPECT_NEAR(estimates("poly:0,0,0,1", "standard", Correction::W1)[middle] - ours, 4, 4e-12);
  EXPECT_NEAR(estimates("poly:0,0,0,1", "improved", Correction::W1)[middle] - ours, 8.0 / 3, 4e-12);
}

TEST(Facts, InteriorErrorRatioIsOneThirdPlusOwnWeight) {
  const Exact exact;
  EXPECT_EQ(exact.at(middle, 1).w[middle], Rational(1, 3));
  EXPECT_EQ(Rational(Rational(8, 3) / 4), Rational(1, 3) + exact.at(middle, 1).w[middle]);
}

/// Error of the first particle over f'' dx = 2.
Rational first_error(const Exact& exact, const Rational& estimate) {
  return Rational((estimate - 2 * exact.cloud.X[0]) / 2);
}
double our_first_error(const std::string& estimator, Correction pair) {
  return (estimates("poly:0,0,1", estimator, pair).front() - 1) / 2;
}

TEST(Facts, FirstParticleStandardW1) {
  const Exact exact;
  EXPECT_EQ(first_error(exact, second::standard(exact.at(0, 1), exact.X2)), Rational(267780, 339889));
  EXPECT_NEAR(our_first_error("standard", Correction::W1), 267780.0 / 339889, tolerance);
}

TEST(Facts, FirstParticleImprovedW1) {
  const Exact exact;
  // own weight 1 - 71/583 = 512/583 times the standard error
  const Rational expected = Rational(267780, 339889) * Rational(512, 583);
  EXPECT_EQ(first_error(exact, second::improved(exact.at(0, 1), exact.cloud, 0, exact.X2)), expected);
  EXPECT_NEAR(expected.convert_to<double>(), 0.691899, 5e-7);  // six digits of an independent calculation
  EXPECT_NEAR(our_first_error("improved", Correction::W1), expected.convert_to<double>(), tolerance);
}

TEST(Facts, FirstParticleStandardW0) {
  const Exact exact;
  EXPECT_EQ(first_error(exact, second::standard(exact.at(0, 0, true), exact.X2)), Rational(160, 151));
  EXPECT_NEAR(our_first_error("standard", Correction::W0), 160.0 / 151, tolerance);
}

TEST(Facts, FirstParticleImprovedW0) {
  const Exact exact;
  EXPECT_EQ(first_error(exact, second::improved(exact.at(0, 0, true), exact.cloud, 0, exact.X2)),
            Rational(8291, 9664));
  EXPECT_NEAR(our_first_error("improved", Correction::W0), 8291.0 / 9664, tolerance);
}

TEST(Facts, ImprovedErrorOfAQuadraticIsOwnWeightTimesStandardErrorOnAnyCloud) {
  Discretisation d;
  d.n = 30;
  d.jitter = 0.4;
  d.seed = 7;
  d.radius.value = 3.3;
  const TestField field = parse_field("poly:0,0,1");
  const Cloud<1> cloud = make_cloud(d);
  const auto standard = gradient_rows(d, {field}, {{"standard", Correction::W1}});
  const auto improved = gradient_rows(d, {field}, {{"improved", Correction::W1}});
  for (std::size_t i = 0; i < standard.size(); ++i) {
    second::Cloud<long double> copy;
    for (const auto& X : cloud.X) copy.X.push_back(X[0]);
    copy.V.assign(cloud.V.begin(), cloud.V.end());
    const auto own =
        second::weights<long double>(copy, copy.X[i], second::Kernel::cubic, d.support() / 2.0L, 1).w[i];
    // errors of size f'' dx = 0.3 from values up to 25
    EXPECT_NEAR(improved[i].error, static_cast<double>(own) * standard[i].error, 1e-12) << "particle " << i;
  }
}

TEST(Facts, WithRadius18StandardAndImprovedAreTheSameOperator) {
  for (const char* field : {"poly:0,0,1", "poly:0,0,0,1", "sin:1", "exp:0.3"}) {
    const auto a = estimates(field, "standard", Correction::W1, 1.8),
               b = estimates(field, "improved", Correction::W1, 1.8);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-12 * 1000) << field << " " << i;  // values to 4096
    // inside it is the central difference
    const double central = (value(parse_field(field), 9.5) - value(parse_field(field), 7.5)) / 2;
    EXPECT_NEAR(a[middle], central, 1e-12 * 1000) << field;
  }
}

/// Sum of a_m q^m from 0 to 1 and from 1 to 2 of q^k w(q), exactly: a moment of the half-line.
Rational half_moment(int k) {
  const auto integral = [&](const std::vector<Rational>& polynomial, int from, int to) {
    Rational sum = 0;
    for (std::size_t m = 0; m < polynomial.size(); ++m) {
      Rational upper = 1, lower = 1;
      for (std::size_t p = 0; p <= m + k; ++p) upper *= to, lower *= from;
      sum += polynomial[m] * (upper - lower) / Rational(static_cast<int>(m) + k + 1);
    }
    return sum;
  };
  const Rational s(2, 3);
  return integral({s, 0, -s * Rational(3, 2), s * Rational(3, 4)}, 0, 1) +
         integral({2 * s, -3 * s, s * Rational(3, 2), -s / 4}, 1, 2);
}

TEST(Facts, HalfLineContinuumAtTheWall) {
  const Rational beta = half_moment(1) / half_moment(2);
  const Rational alpha = 1 / (half_moment(0) - beta * half_moment(1));
  EXPECT_EQ(half_moment(0), Rational(1, 2));
  EXPECT_EQ(beta, Rational(7, 5));
  EXPECT_EQ(alpha, Rational(75, 13));
  // the particles' sums are midpoint rules of these integrals: second order in dx, and Richardson's
  // extrapolation of two levels is fourth order (the cubic spline is twice differentiable)
  Discretisation d;
  d.length = 4;
  d.radius = {2, true};  // h = 1
  const auto at_wall = [&](Index n) {
    d.n = n;
    return explore(d, 0);
  };
  const auto coarse = at_wall(400), fine = at_wall(800);
  const double error = coarse.alpha - 75.0 / 13, finer = fine.alpha - 75.0 / 13;
  EXPECT_NEAR(std::log2(error / finer), 2, 0.01);
  EXPECT_NEAR(std::log2((coarse.beta - 1.4) / (fine.beta - 1.4)), 2, 0.01);
  EXPECT_NEAR((4 * fine.alpha - coarse.alpha) / 3, 75.0 / 13, 1e-8);  // dx^4 = 6e-10
  EXPECT_NEAR((4 * fine.beta - coarse.beta) / 3, 1.4, 1e-8);
}

TEST(Facts, ResponseFormulas) {
  std::vector<double> thetas;
  for (int m = 1; m <= 64; ++m) thetas.push_back(3.14159265358979323846 * m / 64);
  const auto kernel = kernel_named<1>("cubic");
  const auto standard = response(kernel, 4, {"standard", Correction::W1}, thetas);
  const auto improved = response(kernel, 4, {"improved", Correction::W1}, thetas);
  const auto bond = response(kernel, 4, {"bond", Correction::W1}, thetas);
  const auto narrow = response(kernel, 1.8, {"standard", Correction::W1}, thetas);
  const auto narrow_improved = response(kernel, 1.8, {"improved", Correction::W1}, thetas);
  for (std::size_t k = 0; k < thetas.size(); ++k) {
    const double theta = thetas[k], s = std::sin(theta), c = std::cos(theta);
    EXPECT_NEAR(standard[k], s * std::pow(std::cos(theta / 2), 4), tolerance);
    EXPECT_NEAR(improved[k], s * (5 + 3 * c + c * c) / 9, tolerance);
    EXPECT_NEAR(bond[k], s * (17 + 6 * c + c * c) / 36, tolerance);
    EXPECT_NEAR(narrow[k], s, tolerance);
    EXPECT_NEAR(narrow_improved[k], s, tolerance);
  }
}

TEST(Facts, ResponseIsTheEstimateOfASine) {
  // the definition, through the whole library: estimate sin(kX + phi) on a body and divide by cos(kX + phi)
  const double theta = 1.1;
  Discretisation d = unit_lattice(4);
  const auto rows = gradient_rows(d, {parse_field("sin:1,1.1,0.3")}, {{"improved", Correction::W1}});
  const double expected = response(kernel_named<1>("cubic"), 4, {"improved", Correction::W1}, {theta})[0];
  EXPECT_NEAR(rows[middle].value, expected * std::cos(1.1 * 8.5 + 0.3), tolerance);
}

TEST(Facts, NoEstimatorSeesTheAlternatingModeButTheImprovedOneSeesItsNeighbours) {
  const double near = 1e-2, theta = 3.14159265358979323846 - near;
  const auto kernel = kernel_named<1>("cubic");
  const double s = response(kernel, 4, {"standard", Correction::W1}, {theta})[0];
  const double t = response(kernel, 4, {"improved", Correction::W1}, {theta})[0];
  EXPECT_NEAR(s / std::pow(near, 5), 1.0 / 16,
              1e-5);                     // next term (pi - theta)^2 / 48; rounding 1e-17 / 1e-10
  EXPECT_NEAR(t / near, 1.0 / 3, 1e-4);  // next term of size (pi - theta)^2
}

}  // namespace
