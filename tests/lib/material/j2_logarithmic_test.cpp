// J2 plasticity in logarithmic strain: check values of a study of paper 003
// that was made apart from this library, and the properties that every such law
// must have.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "lib/material/models/j2_logarithmic.hpp"

namespace plumb {
namespace {

const Elastic copper_elastic{117e9, 0.35, 8930}, steel_elastic{206.9e9, 0.29, 7850};
const J2Logarithmic copper(copper_elastic, {0.4e9, 0.1e9, std::nullopt, 0});
const J2Logarithmic steel(steel_elastic, {0.45e9, 129.24e6, 0.715e9, 16.93});

Mat<3> sheared(double by) {
  Mat<3> F = Mat<3>::Identity();
  F(0, 1) = by;
  return F;
}
Mat<3> second() {
  Mat<3> F;
  F << 1.02, 0.25, 0, 0, 0.97, 0.01, 0.03, 0, 1.01;
  return F;
}
Mat<3> stretched(double by) {
  return Vec<3>(by, 1 / std::sqrt(by), 1 / std::sqrt(by)).asDiagonal();
}

class Random {
 public:
  double next() { return 2 * static_cast<double>(random_() >> 11) * 0x1p-53 - 1; }
  Mat<3> deformation(double size) {
    Mat<3> F = Mat<3>::Identity();
    for (int n = 0; n < 9; ++n) F(n / 3, n % 3) += size * next();
    return F;
  }
  Mat<3> rotation() {
    return Eigen::Quaterniond(next(), next(), next(), next()).normalized().toRotationMatrix();
  }

 private:
  std::mt19937_64 random_{11};
};

// Printed values have 15 digits; stresses are differences of numbers of size
// kappa = 130 and 164 GPa.
constexpr double digits = 1e-14, of_stress = 1e-15 * 200e9 * 10;
// An increment rounds some twenty times (an eigenproblem and products of matrices), by 2e-16 each.
constexpr double ten_steps = 10 * 20 * 2e-16;

TEST(J2Logarithmic, CheckValuesOfCopper) {
  J2Logarithmic::History history;
  Response r = copper.stress(sheared(0.1), history);
  EXPECT_NEAR(history.plastic_strain, 0.0545920806956853, digits);
  EXPECT_NEAR(r.equivalent, 405459208.069568, of_stress);
  EXPECT_NEAR(r.P(0, 0), -11689995.772914, of_stress);
  EXPECT_NEAR(r.P(0, 1), 233799915.458275, of_stress);
  EXPECT_NEAR(r.P(1, 0), 234968915.035566, of_stress);
  EXPECT_NEAR(history.Cp_inverse(0, 0), 1.00920272837478, digits);
  EXPECT_NEAR(history.Cp_inverse(0, 1), -0.0945790731988506, digits);
  EXPECT_EQ(r.iterations, 1);  // linear hardening
  r = copper.stress(second(), history);
  EXPECT_NEAR(history.plastic_strain, 0.147010167531522, digits);
  EXPECT_NEAR(r.equivalent, 414701016.753153, of_stress);
  EXPECT_NEAR(r.P(0, 0), -61988983.1272856, of_stress);
  EXPECT_NEAR(r.P(0, 1), 222730770.177657, of_stress);
}

TEST(J2Logarithmic, CheckValuesOfSteelThatSaturates) {
  EXPECT_NEAR(steel.yield_at(0.1).value, 679172799.343775, of_stress);
  EXPECT_NEAR(steel.yield_at(1).value, 844239988.23369, of_stress);
  J2Logarithmic::History history, stretch;
  Response r = steel.stress(sheared(0.1), history);
  EXPECT_NEAR(history.plastic_strain, 0.0551424630859562, digits);
  EXPECT_NEAR(r.equivalent, 617941636.8379, of_stress);
  EXPECT_NEAR(r.P(0, 1), 356323643.847447, of_stress);
  r = steel.stress(second(), history);
  EXPECT_NEAR(history.plastic_strain, 0.147262478664183, digits);
  EXPECT_NEAR(r.equivalent, 712130244.239188, of_stress);
  r = steel.stress(stretched(1.1), stretch);
  EXPECT_NEAR(stretch.plastic_strain, 0.0925185138927078, digits);
  EXPECT_NEAR(r.equivalent, 671622880.364636, of_stress);
}

TEST(J2Logarithmic,
     IsochoricStretchHasAClosedForm) {  // a = (3 mu ln s - tau_0)/(3 mu + H), in
                                        // one step or many
  const double mu = copper_elastic.shear_modulus(), s = 1.1;
  const double expected = (3 * mu * std::log(s) - 0.4e9) / (3 * mu + 0.1e9);
  EXPECT_NEAR(expected, 0.0921623626023231, 1e-15);
  for (const int steps : {1, 7, 50}) {
    J2Logarithmic::History history;
    Response r;
    for (int n = 1; n <= steps; ++n) r = copper.stress(stretched(std::pow(s, double(n) / steps)), history);
    EXPECT_NEAR(history.plastic_strain, expected,
                digits);  // radial: steps make no difference
    EXPECT_NEAR(r.equivalent, 0.4e9 + 0.1e9 * expected, of_stress);
  }
}

TEST(J2Logarithmic, WithInfiniteYieldStressItIsHenckysElasticLaw) {
  const double inf = std::numeric_limits<double>::infinity();
  const J2Logarithmic law({2.5, 0.25, 1}, {inf, 0, std::nullopt, 0});  // mu = 1, kappa = 5/3
  J2Logarithmic::History history;
  Mat<3> F;
  F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.15, -0.2, 0.1, 1.2;
  // From the logarithms of the eigenvalues of F F^T with 40 digits, P by
  // differences of W.
  const Response r = law.stress(F, history);
  EXPECT_NEAR(law.energy(F, history), 0.16820583346210366, 4e-15);
  EXPECT_NEAR(r.P(0, 0), 0.1920553605334337, 4e-15);
  EXPECT_NEAR(r.P(0, 1), 0.31579866613011608, 4e-15);
  EXPECT_NEAR(r.P(2, 0), -0.26415252208106466, 4e-15);
  EXPECT_NEAR(r.P(2, 2), 0.32239506296321495, 4e-15);
  EXPECT_EQ(r.iterations, 0);
  EXPECT_EQ(history.plastic_strain, 0);
  EXPECT_EQ(history.Cp_inverse, Mat<3>(Mat<3>::Identity()));
}

/// Ten random increments; check(F before, history before, F, history,
/// response).
template <class Check>
void along_a_path(const J2Logarithmic& law, Check&& check) {
  Random random;
  J2Logarithmic::History history;
  Mat<3> F = Mat<3>::Identity();
  for (int n = 0; n < 10; ++n) {
    const J2Logarithmic::History before = history;
    const Mat<3> last = F;
    F = random.deformation(0.04) * F;
    const Response r = law.stress(F, history);
    check(last, before, F, history, r);
  }
}

TEST(J2Logarithmic, PlasticFlowKeepsTheVolumeAndDissipates) {
  for (const J2Logarithmic& law : {copper, steel})
    along_a_path(
        law, [&](const Mat<3>&, const auto& before, const Mat<3>& F, const auto& history, const Response& r) {
          EXPECT_NEAR(history.Cp_inverse.determinant(), 1, ten_steps);
          EXPECT_GE(history.plastic_strain, before.plastic_strain);
          EXPECT_GE(r.plastic_work, 0);
          EXPECT_NEAR(r.equivalent, law.yield_at(history.plastic_strain).value,
                      of_stress);  // each of them yields
          const Mat<3> tau = r.P * F.transpose();
          EXPECT_LT((tau - tau.transpose()).norm(), of_stress);
          const Mat<3> deviator = tau - tau.trace() / 3 * Mat<3>::Identity();
          EXPECT_NEAR(r.equivalent, std::sqrt(1.5) * deviator.norm(), of_stress);
        });
}

// Work done on the point from rest, less the elastic energy that is stored, is
// the plastic work: to second order in the increment, so a path in 400 parts
// with strains of 5e-4 each leaves a part in a thousand.
TEST(J2Logarithmic, WorkIsElasticEnergyAndPlasticWork) {
  J2Logarithmic::History history;
  Mat<3> last = Mat<3>::Identity(), P_last = Mat<3>::Zero();
  double work = 0, plastic = 0;
  for (int n = 1; n <= 400; ++n) {
    const double t = n / 400.0;
    Mat<3> F = sheared(0.2 * std::sin(4 * t));  // forwards and back
    F(2, 2) += 0.02 * t;
    const Response r = steel.stress(F, history);
    work += 0.5 * ((P_last + r.P).cwiseProduct(F - last)).sum();
    plastic += r.plastic_work;
    last = F;
    P_last = r.P;
  }
  EXPECT_NEAR(work - steel.energy(last, history), plastic, 2e-3 * plastic);
  EXPECT_GT(plastic, 50e6);  // 600 MPa times .15
}

TEST(J2Logarithmic, ARotationTurnsTheStressAndLeavesTheHistory) {
  Random random;
  J2Logarithmic::History still, turned;
  Mat<3> F = Mat<3>::Identity();
  for (int n = 0; n < 10; ++n) {
    F = random.deformation(0.04) * F;
    const Mat<3> Q = random.rotation();
    const Mat<3> P = steel.stress(F, still).P, R = steel.stress(Mat<3>(Q * F), turned).P;
    EXPECT_LT((R - Q * P).norm(), 10 * of_stress);
    EXPECT_LT((still.Cp_inverse - turned.Cp_inverse).norm(), ten_steps);
    EXPECT_NEAR(still.plastic_strain, turned.plastic_strain, ten_steps);
  }
}

TEST(J2Logarithmic, TangentIsTheDerivativeOfTheAlgorithm) {
  const auto compare = [](const J2Logarithmic& law, const Mat<3>& F, const J2Logarithmic::History& before) {
    const Mat<9> A = law.tangent(F, before);
    // fourth order with h = 1e-3: h^4/30 times a fifth derivative of some 1e3,
    // and round-off of 1e-16/h
    const double h = 1e-3;
    for (int n = 0; n < 9; ++n) {
      const auto at = [&](double k) -> Mat<3> {
        J2Logarithmic::History scratch = before;
        Mat<3> G = F;
        G(n / 3, n % 3) += k * h;
        return law.stress(G, scratch).P;
      };
      const Mat<3> slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
      for (int m = 0; m < 9; ++m) EXPECT_NEAR(A(m, n), slope(m / 3, m % 3), 1e-8 * A.norm()) << m << ' ' << n;
    }
  };
  for (const J2Logarithmic& law : {copper, steel})
    along_a_path(law, [&](const Mat<3>&, const auto& before, const Mat<3>& F, const auto&, const Response&) {
      compare(law, F, before);
    });
  const J2Logarithmic hard(copper_elastic, {1e12, 0, std::nullopt, 0});  // elastic, and equal stretches
  compare(hard, Mat<3>::Identity(), {});
  compare(hard, stretched(1.3), {});
  compare(copper, stretched(1.3), {});
}

TEST(J2Logarithmic, TangentAtRestIsThatOfTheElasticConstants) {
  const Mat<9> A = copper.tangent(Mat<3>::Identity(), {});
  const double mu = copper_elastic.shear_modulus(), lambda = copper_elastic.lame(), E = copper_elastic.young;
  EXPECT_NEAR(A(0, 0), lambda + 2 * mu, 1e-14 * E);
  EXPECT_NEAR(A(0, 4), lambda, 1e-14 * E);
  EXPECT_NEAR(A(1, 1), mu, 1e-14 * E);
  EXPECT_NEAR(A(1, 3), mu, 1e-14 * E);
}

TEST(ReturnMapping, StaysInItsBracketWhereNewtonAloneWouldLeaveIt) {
  // flat, steep between 0.5 and 0.6, flat: Newton alone goes from 1 to 0.03 and
  // back for ever
  const auto yield = [](double g) {
    return g < 0.5 ? Yield{1, 0} : g < 0.6 ? Yield{1 + 29 * (g - 0.5), 29} : Yield{3.9, 0};
  };
  const PlasticIncrement found = plastic_increment(4.0, 1.0, yield);
  EXPECT_NEAR(found.strain, 17.5 / 32, 1e-15);
  EXPECT_LE(found.iterations, 60);  // halving gains a bit each time
  const PlasticIncrement linear = plastic_increment(4.0, 1.0, [](double g) { return Yield{1 + 2 * g, 2}; });
  EXPECT_NEAR(linear.strain, 0.6, 1e-15);
  EXPECT_EQ(linear.iterations, 1);
}

}  // namespace
}  // namespace plumb
