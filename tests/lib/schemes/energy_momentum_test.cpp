// The energy-momentum rule: momenta and energy, order, and what it is for.
#include "lib/schemes/implicit/energy_momentum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/convergence/order_fit.hpp"
#include "lib/core/error.hpp"
#include "lib/schemes/element/element.hpp"
#include "lib/schemes/implicit/midpoint.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"
#include "tests/support/mixed.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// A free block that turns at 30 rad/s and stretches.
template <int d>
BodyMotion spinning(const Cloud<d>& cloud) {
  BodyMotion motion{VectorXd::Zero(d * cloud.size()), VectorXd::Zero(d * cloud.size())};
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d>& X = cloud.X[i];
    motion.v[d * i] = -30 * X[1] + 10 * X[0] + 1;
    motion.v[d * i + 1] = 30 * X[0];
  }
  return motion;
}

struct Kept {
  double linear, angular, energy;  ///< relative changes
  double strain;                   ///< share of the energy at the end
};

template <int d>
Kept run_free(const StoredEnergy<d>& stored, const Elastic& elastic, const LawChoice& law, double dt,
              int steps) {
  const Actions<d> nothing;
  BodyMotion motion = spinning(stored.cloud);
  EnergyMomentum<d> rule(stored, objective_law<d>(law, elastic), nothing, 1e-13, motion);
  const auto measures = [&] {
    Vec<d> p = Vec<d>::Zero();
    Mat<d> L = Mat<d>::Zero();
    double kinetic = 0, scale = 0;
    for (Index i = 0; i < stored.cloud.size(); ++i) {
      const double m = stored.elastic.density * stored.cloud.V[i];
      const Vec<d> v = motion.v.template segment<d>(d * i);
      const Vec<d> x = stored.cloud.X[i] + motion.u.template segment<d>(d * i);
      p += m * v;
      L += m * (x * v.transpose() - v * x.transpose());
      kinetic += m * v.squaredNorm() / 2;
      scale += m * v.norm();
    }
    return std::tuple(p, L, kinetic, scale);
  };
  const auto [p0, L0, K0, scale] = measures();
  const double E0 = K0 + stored.energy(motion.u);
  for (int n = 0; n < steps; ++n) {
    const NewtonResult result = rule.step(motion, dt);
    if (!result.converged()) {
      ADD_FAILURE() << "step " << n << " ended with residual " << result.residuals.back();
      break;
    }
  }
  const auto [p1, L1, K1, unused] = measures();
  (void)unused;
  const double strain = stored.energy(motion.u);
  return {(p1 - p0).norm() / scale, (L1 - L0).norm() / L0.norm(), (K1 + strain) / E0 - 1, strain / E0};
}

template <int d>
void all_three_stay() {
  const LawChoice law("neo-hookean");
  // 80 steps, each to the round-off of its forces
  const Solid<d> solid = testing::elastic_body<d>({"compatible"}, law, 0.5, 0.2, 4);
  for (const StoredEnergy<d>& stored :
       {stored_energy(solid),
        Element<d>({testing::cube<d>(2), law, testing::rubber}, {}, {}).stored_energy()}) {
    const Kept kept = run_free<d>(stored, testing::rubber, law, 5e-4, 80);
    EXPECT_LT(kept.linear, 1e-10);
    EXPECT_LT(kept.angular, 1e-10);
    EXPECT_LT(std::abs(kept.energy), 1e-9);
    EXPECT_GT(kept.strain, 1e-3);  // it does deform
  }
}

TEST(EnergyMomentum, KeepsBothMomentaAndTheEnergy) {
  all_three_stay<2>();
  all_three_stay<3>();
}

TEST(EnergyMomentum, OfLawsUnderPlaneStressToo) {
  const LawChoice law("mooney-rivlin", {}, Plane::stress);
  const Kept kept =
      run_free<2>(stored_energy(testing::elastic_body<2>({}, law, 0, 0, 4)), testing::rubber, law, 5e-4, 80);
  EXPECT_LT(kept.angular, 1e-10);
  EXPECT_LT(std::abs(kept.energy), 1e-9);
}

/// Steps of the midpoint rule in the limit: the two differ by a term of second order.
TEST(EnergyMomentum, IsOfSecondOrder) {
  const LawChoice law("neo-hookean");
  const StoredEnergy<2> stored = stored_energy(testing::elastic_body<2>({}, law, 0, 0, 4));
  const Actions<2> nothing;
  const auto end_of = [&](int steps) {
    BodyMotion motion = spinning(stored.cloud);
    EnergyMomentum<2> rule(stored, objective_law<2>(law, testing::rubber), nothing, 1e-11, motion);
    for (int n = 0; n < steps; ++n) EXPECT_TRUE(rule.step(motion, 4e-3 / steps).converged());
    return motion.u;
  };
  BodyMotion fine = spinning(stored.cloud);
  Midpoint<2> midpoint(stored, nothing, 1e-12, fine);
  for (int n = 0; n < 512; ++n) EXPECT_TRUE(midpoint.step(fine, 4e-3 / 512).converged());
  std::vector<Level> levels;
  for (const int steps : {8, 16, 32, 64}) levels.push_back({4e-3 / steps, (end_of(steps) - fine.u).norm()});
  const OrderFit fit = fit_order(levels);
  EXPECT_NEAR(fit.order, 2, 0.15);  // the reference has 1/64 of the error of the finest level
}

template <int d>
void expect_tangent(const LawChoice& choice) {
  const PointLaw<d> law = objective_law<d>(choice, testing::rubber);
  Mat<d> before = Mat<d>::Identity(), middle = Mat<d>::Identity();
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j) {
      before(i, j) += 0.05 * std::sin(1 + 2 * i + 5 * j);
      middle(i, j) += 0.07 * std::cos(3 * i + 2 * j);
    }
  const Mat<d* d> tangent = tangent_of_step<d>(law, before, middle);
  constexpr double step = 1e-6;
  for (int n = 0; n < d * d; ++n) {
    Mat<d> more = middle, less = middle;
    more(n / d, n % d) += step;
    less(n / d, n % d) -= step;
    const Mat<d> slope =
        (stress_of_step<d>(law, before, more) - stress_of_step<d>(law, before, less)) / (2 * step);
    for (int m = 0; m < d * d; ++m)  // step^2 of the third derivative, and round-off of P over the step
      EXPECT_NEAR(tangent(m, n), slope(m / d, m % d), 1e-7 * tangent.norm()) << choice.name << m << n;
  }
  const double work = stress_of_step<d>(law, before, middle).cwiseProduct(2 * (middle - before)).sum();
  EXPECT_NEAR(work, law.energy(2 * middle - before) - law.energy(before), 1e-12 * tangent.norm());
}

TEST(EnergyMomentum, TangentIsTheDerivativeOfTheStressOfTheStep) {
  for (const char* name :
       {"neo-hookean", "mooney-rivlin", "polyconvex", "saint-venant-kirchhoff", "neo-hookean-logarithmic"}) {
    expect_tangent<1>(LawChoice(name));
    expect_tangent<2>(LawChoice(name));
    expect_tangent<3>(LawChoice(name));
  }
  expect_tangent<2>(LawChoice("mooney-rivlin", {}, Plane::stress));
}

/// Steps in which the symmetric tangent gains less than a digit. With the exact one each iteration squares the
/// residual: its logarithm doubles.
TEST(EnergyMomentum, TakesSteepStepsQuadratically) {
  const LawChoice law("neo-hookean");
  const StoredEnergy<2> stored = stored_energy(testing::elastic_body<2>({}, law, 0, 0, 4));
  const Actions<2> nothing;
  BodyMotion motion = spinning(stored.cloud);
  EnergyMomentum<2> rule(stored, objective_law<2>(law, testing::rubber), nothing, 1e-12, motion);
  for (int n = 0; n < 5; ++n) {
    const NewtonResult result = rule.step(motion, 8e-3);
    ASSERT_TRUE(result.converged()) << "step " << n << " ended with residual " << result.residuals.back();
    std::vector<double> exponents;
    for (std::size_t k = 0; k + 1 < result.residuals.size(); ++k)
      if (const double r = result.residuals[k]; r < 0.1 && r > 1e-6)  // small, and its square not round-off
        exponents.push_back(std::log(result.residuals[k + 1]) / std::log(r));
    EXPECT_FALSE(exponents.empty());
    for (const double exponent : exponents) EXPECT_GT(exponent, 1.5) << "step " << n;
  }
}

TEST(EnergyMomentum, RefusesALawThatFeelsRotations) {
  EXPECT_THROW(objective_law<2>(LawChoice("linear-elastic"), testing::rubber), InputError);
}

}  // namespace
}  // namespace plumb
