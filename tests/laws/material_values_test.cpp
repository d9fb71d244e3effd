// Values: elastic constants against handbook numbers, and every model of chapter 4 against its energy as a
// function of the three principal stretches, differentiated by hand. A law that only asks for consistency
// would take any ratio of c1 and c2.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

#include "lib/material/laws.hpp"
#include "tests/support/clouds.hpp"

namespace plumb {
namespace {

const Elastic rubber{17e6, 0.45, 1100};

TEST(ElasticConstants, OfSteelAreThoseOfTheHandbook) {
  const Elastic steel{210e9, 0.3, 7850};
  EXPECT_NEAR(steel.shear_modulus(), 80.7692307692e9, 1);  // ten digits
  EXPECT_NEAR(steel.bulk_modulus(), 175e9, 1);
  EXPECT_NEAR(steel.lame(), 121.153846154e9, 1);
  EXPECT_NEAR(steel.wave_speed(), 6000.98, 0.01);  // sqrt(E (1 - nu)/((1 + nu)(1 - 2 nu) rho))
  EXPECT_NEAR(steel.shear_wave_speed(), 3207.66, 0.01);
}

TEST(ElasticConstants, ObeyTheOtherFormsOfTheSameRelations) {
  for (const double nu : {-0.3, 0.0, 0.25, 0.45, 0.4999}) {
    const Elastic e{17e6, nu, 1100};
    const double E = e.young, lambda = e.lame(), mu = e.shear_modulus(), kappa = e.bulk_modulus();
    const double near = 1e-10 * kappa;  // 1 - 2 nu loses four digits
    EXPECT_NEAR(lambda, E * nu / ((1 + nu) * (1 - 2 * nu)), near) << nu;
    EXPECT_NEAR(9 * kappa * mu / (3 * kappa + mu), E, near) << nu;
    EXPECT_NEAR((3 * kappa - 2 * mu) / (2 * (3 * kappa + mu)), nu, 1e-12) << nu;
    EXPECT_NEAR(e.density * e.wave_speed() * e.wave_speed(), kappa + 4 * mu / 3, near) << nu;
    EXPECT_NEAR(e.density * e.shear_wave_speed() * e.shear_wave_speed(), mu, near) << nu;
  }
}

/// An energy of three principal stretches and its slope with respect to the first argument [Pa].
struct Stretches {
  std::string_view model;
  double (*energy)(double, double, double);
  double (*slope)(double, double, double);
};
const double mu = 17e6 / 2.9, kappa = 17e6 / 0.3;

double volumetric(double J) {
  return kappa / 2 * (J - 1) * (J - 1);
}
double neo_hookean(double a, double b, double c) {
  const double J = a * b * c;
  return mu / 2 * ((a * a + b * b + c * c) / std::cbrt(J * J) - 3) + volumetric(J);
}
double neo_hookean_slope(double a, double b, double c) {
  const double J = a * b * c, I1 = a * a + b * b + c * c;
  return mu / std::cbrt(J * J) * (a - I1 / (3 * a)) + kappa * (J - 1) * b * c;
}
/// 2 (c1 + c2) = mu and c2 = c1/4: c1 = 2/5 mu, c2 = 1/10 mu.
double mooney_rivlin(double a, double b, double c) {
  const double J = a * b * c, I1 = a * a + b * b + c * c, I2 = a * a * b * b + b * b * c * c + c * c * a * a;
  return 2 * mu / 5 * (I1 * std::pow(J, -2.0 / 3) - 3) + mu / 10 * (I2 * std::pow(J, -4.0 / 3) - 3) +
         volumetric(J);
}
double mooney_rivlin_slope(double a, double b, double c) {
  const double J = a * b * c, I1 = a * a + b * b + c * c, I2 = a * a * b * b + b * b * c * c + c * c * a * a;
  return 4 * mu / 5 * std::pow(J, -2.0 / 3) * (a - I1 / (3 * a)) +
         mu / 5 * std::pow(J, -4.0 / 3) * (a * (b * b + c * c) - 2 * I2 / (3 * a)) + kappa * (J - 1) * b * c;
}
const Stretches known[] = {{"neo-hookean", neo_hookean, neo_hookean_slope},
                           {"mooney-rivlin", mooney_rivlin, mooney_rivlin_slope}};

/// A rotation of the plane or of space.
template <int d>
Mat<d> rotation(test::Numbers& numbers) {
  Mat<d> Q = Mat<d>::Identity();
  if constexpr (d == 2) Q = Eigen::Rotation2Dd(3 * numbers.next()).toRotationMatrix();
  if constexpr (d == 3)
    Q = Eigen::AngleAxisd(3 * numbers.next(), numbers.vector<3>().normalized()).toRotationMatrix();
  return Q;
}

template <int d>
void expect_values(const Stretches& law, const Vec<3>& stretch) {
  test::Numbers numbers(7);
  const Mat<d> R = rotation<d>(numbers), Q = rotation<d>(numbers);
  Vec<3> l = Vec<3>::Ones();
  l.head<d>() = stretch.head<d>();
  const Mat<d> F = R * l.head<d>().asDiagonal() * Q.transpose();
  Vec<3> slope;
  for (int k = 0; k < 3; ++k) slope[k] = law.slope(l[k], l[(k + 1) % 3], l[(k + 2) % 3]);
  const Mat<d> P = R * slope.head<d>().asDiagonal() * Q.transpose();
  with_elastic_law<d>(LawChoice(std::string(law.model)), rubber, [&](const auto& material) {
    EXPECT_NEAR(material.energy(F), law.energy(l[0], l[1], l[2]),
                1e-14 * 10 * kappa);  // ten roundings of kappa
    EXPECT_LT((material.first_piola(F) - P).norm(), 1e-13 * (P.norm() + kappa));
  });
}

TEST(MaterialValues, AreThoseOfThePrincipalStretches) {
  for (const auto& law : known)
    for (const Vec<3>& stretch :
         {Vec<3>(1.3, 0.9, 0.7), Vec<3>(0.6, 1.5, 1.2), Vec<3>(2.0, 0.8, 0.6), Vec<3>(1, 1, 1)}) {
      SCOPED_TRACE(law.model);
      expect_values<1>(law, stretch);
      expect_values<2>(law, stretch);
      expect_values<3>(law, stretch);
    }
}

/// Simple shear by g is isochoric: W = mu g^2/2 for both models in three dimensions (I1 = I2 = 3 + g^2), and
/// the shear stress is mu g.
TEST(MaterialValues, SimpleShearIsTheSameForBoth) {
  Mat<3> F = Mat<3>::Identity();
  F(0, 1) = 0.8;
  for (const auto& law : known)
    with_elastic_law<3>(LawChoice(std::string(law.model)), rubber, [&](const auto& material) {
      EXPECT_NEAR(material.energy(F), 0.5 * mu * 0.64, 1e-14 * 10 * kappa) << law.model;
      const Mat<3> cauchy = material.first_piola(F) * F.transpose();
      EXPECT_NEAR(cauchy(0, 1), mu * 0.8, 1e-13 * kappa) << law.model;
    });
}

}  // namespace
}  // namespace plumb
