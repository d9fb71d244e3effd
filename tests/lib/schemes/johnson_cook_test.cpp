// The law of Johnson and Cook at one point, by rates: values that an independent program found by bisection.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/schemes/rate_law.hpp"

namespace plumb {
namespace {

/// Aluminium of paper 001, table 1.
LawChoice aluminium() {
  return {"johnson-cook",
          {{"yield", 164e6},
           {"hardening", 211e6},
           {"hardening_exponent", 0.465},
           {"rate_factor", 0.002},
           {"reference_rate", 1},
           {"softening_exponent", 1.419},
           {"reference_temperature", 292},
           {"melting_temperature", 925},
           {"heat_capacity", 885},
           {"damage_1", -0.77},
           {"damage_2", 1.45},
           {"damage_3", -0.47},
           {"damage_4", 0},
           {"damage_5", 1.6}}};
}
LawChoice pmma() {
  return {"johnson-cook",
          {{"yield", 212e6},
           {"hardening", 580e6},
           {"hardening_exponent", 3.5},
           {"rate_factor", 0.081},
           {"reference_rate", 0.001},
           {"softening_exponent", 0.749},
           {"reference_temperature", 213},
           {"melting_temperature", 398},
           {"temperature", 293},
           {"heat_capacity", 1470},
           {"damage_1", -1.751},
           {"damage_2", 2.32},
           {"damage_3", -0.773},
           {"damage_4", -0.0491},
           {"damage_5", 0.38}}};
}
Elastic elastic_of(double bulk, double shear, double density) {
  return {9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)), density};
}
RateLaw<3> law_of(const LawChoice& choice) {
  return {choice,
          choice.parameters.contains("temperature") ? elastic_of(5.85e9, 2.2e9, 1186)
                                                    : elastic_of(69e9, 26.5e9, 2800),
          true,
          true,
          std::nullopt,
          "eulerian"};
}

/// A point that is led along increments, with its density and the iterations of its returns.
struct Led {
  RateLaw<3> law;
  RateLaw<3>::Point point = law.at_rest();
  double rho = law.density;
  int most = 0, returns = 0, all = 0;

  /// `steps` equal increments that add up to `whole`, in the time that `size` takes at that rate [1/s].
  void go(const Mat<3>& whole, double size, int steps, double rate) {
    const Mat<3> increment = whole / steps;
    const double swell = 0.5 * increment.trace();
    for (int n = 0; n < steps; ++n) {
      rho *= (1 - swell) / (1 + swell);
      const double before = point.plastic;
      law.advance_by(point, increment, size / steps / rate, rho);
      if (point.plastic == before) continue;
      most = std::max(most, point.iterations);
      all += point.iterations;
      ++returns;
    }
  }
  double q() const { return std::sqrt(1.5 * law.square(point.s)); }
};

Mat<3> isochoric(double e) {
  return Vec<3>(e, -e / 2, -e / 2).asDiagonal();
}
Mat<3> shear(double gamma) {
  Mat<3> G = Mat<3>::Zero();
  G(0, 1) = gamma;
  return G;
}

struct Value {
  double q, plastic, temperature, damage;
};
/// To the digits that are given: eleven of q, thirteen of the plastic strain, ten of the others.
void expect(const Led& led, const Value& value) {
  EXPECT_NEAR(led.q() / value.q, 1, 1e-10);
  EXPECT_NEAR(led.point.plastic / value.plastic, 1, 2e-12);
  EXPECT_NEAR(led.point.temperature / value.temperature, 1, 1e-9);
  EXPECT_NEAR(led.point.damage / value.damage, 1, 1e-9);
}

TEST(JohnsonCookPoint, StretchesWithoutChangeOfVolume) {
  Led led{law_of(aluminium())};
  led.go(isochoric(0.1), 0.1, 100, 1e3);
  expect(led, {2.3811536850e8, 0.0970048381321, 299.6026149, 0.1413440092});
  EXPECT_LE(led.most, 4);  // 3 to 1e-10 of the stress; one more takes it to rounding
  EXPECT_LT(static_cast<double>(led.all) / led.returns, 3.5);
  Led once{law_of(aluminium())};
  once.go(isochoric(0.1), 0.1, 1, 1e3);
  expect(once, {2.3854321870e8, 0.0969994563685, 300.4038363, 0.1396792043});
  Led fast{law_of(aluminium())};
  fast.go(isochoric(0.1), 0.1, 100, 1e5);
  expect(fast, {2.4026361898e8, 0.0969778161135, 299.6692328, 0.141293293});
  Led back{law_of(aluminium())};
  back.go(isochoric(0.05), 0.05, 100, 1e3);
  back.go(isochoric(-0.05), 0.05, 100, 1e3);
  expect(back, {2.3623369602e8, 0.0915473287082, 299.1262649, 0.1334735612});
}

TEST(JohnsonCookPoint, IsPressed) {
  Led led{law_of(aluminium())};
  led.go(Vec<3>(-0.05, 0, 0).asDiagonal(), 0.05, 100, 1e3);
  expect(led, {2.0838135132e8, 0.0307121842601, 294.1182016, 0.001587727463});
  EXPECT_NEAR(led.law.pressure(led.rho) / 3.5377057255e9, 1, 1e-10);
  EXPECT_NEAR(led.rho, 2943.55907292, 1e-8);
}

TEST(JohnsonCookPoint, IsShearedThereAndBack) {
  Led led{law_of(aluminium())};
  led.go(shear(0.4), 0.4, 400, 1e3);
  expect(led, {2.7144568535e8, 0.227522011941, 311.7304494, 0.326944563});
  EXPECT_NEAR(led.point.s(0, 1) / 1.5671603376e8, 1, 1e-10);
  EXPECT_NEAR(led.point.s(0, 0) / 1.0023940545e6, 1, 1e-9);
  led.go(shear(-0.4), 0.4, 400, 1e3);
  expect(led, {3.0670359982e8, 0.451184551926, 335.3353115, 0.6318045621});
  EXPECT_NEAR(led.point.s(0, 1) / -1.7707085410e8, 1, 1e-10);
}

/// Newton's method without a bracket cycles here for a hundred iterations.
TEST(JohnsonCookPoint, EndsWhereTheRateTermIsSteep) {
  Led led{law_of(pmma())};
  led.go(isochoric(0.2), 0.2, 200, 1e3);
  EXPECT_NEAR(led.q() / 1.7347498760e8, 1, 1e-10);
  EXPECT_NEAR(led.point.plastic / 0.173715910969, 1, 1e-11);
  EXPECT_NEAR(led.point.temperature, 310.08450, 1e-5);
  EXPECT_NEAR(led.point.damage, 0.80521, 5e-6);
  EXPECT_LE(led.most, 30);  // halvings of the bracket among them
}

TEST(JohnsonCookPoint, HasTheStrainAtFracture) {
  const JohnsonCook law = make_law<JohnsonCook>(elastic_of(69e9, 26.5e9, 2800), aluminium());
  const double s[] = {-1.0 / 3, 0, 1.0 / 3, 1}, strain[] = {0.9259282, 0.68, 0.4697341, 0.1362533};
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(law.strain_at_fracture(s[n], 1, 292), strain[n], 5e-8);
  EXPECT_EQ(law.strain_at_fracture(1.35, 1, 292), 1e-3);  // beyond 1.3467 the formula is negative
  EXPECT_NEAR(law.triaxiality_of_floor().value(), 1.3467, 5e-5);
  const JohnsonCook brittle = make_law<JohnsonCook>(elastic_of(5.85e9, 2.2e9, 1186), pmma());
  EXPECT_NEAR(brittle.triaxiality_of_floor().value(), 0.3640, 5e-5);
}

TEST(JohnsonCookPoint, AFailedPointBearsNothingButPressure) {
  RateLaw<3> law = law_of(aluminium());
  Led led{law};
  for (int n = 0; n < 20 && led.point.damage < 1; ++n) led.go(isochoric(0.1), 0.1, 100, 1e3);
  ASSERT_GE(led.point.damage, 1);
  EXPECT_EQ(led.point.s.norm(), 0);
  led.go(shear(0.1), 0.1, 10, 1e3);
  EXPECT_EQ(led.point.s.norm(), 0);
  EXPECT_EQ(law.pressure(0.9 * law.density, led.point.damage), 0);
  EXPECT_LT(law.pressure(0.9 * law.density, 0.5), 0);
  EXPECT_GT(law.pressure(1.1 * law.density, led.point.damage), 0);
}

TEST(JohnsonCookPoint, KnowsNothingOfTheCold) {
  LawChoice cold = aluminium();
  EXPECT_EQ(law_of(cold).warnings().size(), 1u);  // the floor of the strain at fracture
  cold.parameters["temperature"] = 280;
  EXPECT_EQ(law_of(cold).warnings().size(), 2u);
  LawChoice odd = aluminium();
  odd.parameters["melting_temperature"] = 292;
  EXPECT_THROW(law_of(odd), InputError);
  const JohnsonCook law = make_law<JohnsonCook>(elastic_of(69e9, 26.5e9, 2800), aluminium());
  EXPECT_EQ(law.warmth(200), 0);
  EXPECT_EQ(law.warmth(2000), 1);
  EXPECT_EQ(law.yield_at({0.1, 2000, 0}, 0.1, 1).value, 0);  // molten
}

}  // namespace
}  // namespace plumb
