// (11) of paper 001 as it is printed, summed over all pairs by hand: stress with artificial stress, viscosity, diffusion.
#include <gtest/gtest.h>

#include "lib/kernel/kernels/cubic_spline.hpp"
#include "lib/schemes/point_fields.hpp"
#include "tests/support/eulerian.hpp"

namespace plumb::testing {
namespace {

/// Of a symmetric tensor what its positive principal values leave, in closed form.
Mat<2> positive_part(const Mat<2>& A) {
  const double half = 0.5 * A.trace(), det = A.determinant(), root = std::sqrt(half * half - det);
  const double low = half - root, high = half + root;
  if (low >= 0) return A;
  if (high <= 0) return Mat<2>::Zero();
  return high / (high - low) * (A - low * Mat<2>::Identity());
}

/// A jittered cloud in rough motion, with all that (11) reads.
class PrintedEquations : public ::testing::Test {
 protected:
  PrintedEquations() : cloud(test::all_clouds<2>()[3].cloud), body(eulerian_body<2>(cloud, options(), soft)) {
    state = body.start(rough_motion<2>(cloud));
    h = body.smoothing_length();
    for (Index i = 0; i < cloud.size(); ++i) {
      x.push_back(cloud.X[i] + vector_at<2>(state.u, i));
      v.push_back(vector_at<2>(state.v, i));
      rho.push_back(state.density[0][i]);
      sigma.emplace_back(tensor_at<2>(state.stress, i) - body.law().pressure(rho[i]) * Mat<2>::Identity());
    }
    for (Index i = 0; i < cloud.size(); ++i) {
      double sum = 0;
      for (Index j = 0; j < cloud.size(); ++j) sum += body.mass()[j] / rho[j] * W((x[i] - x[j]).norm());
      S.push_back(sum);
    }
  }
  static EulerianOptions options() {
    EulerianOptions o = plain("printed");
    o.artificial_stress = 0.3;
    o.viscosity_linear = 2;
    o.viscosity_quadratic = 1;
    o.diffusion = 0.01;
    return o;
  }
  double W(double r) const { return CubicSpline::w<2>(r / h) / (h * h); }
  Vec<2> gradient(const Vec<2>& r) const {
    return CubicSpline::dw<2>(r.norm() / h) / (h * h * h) * r / r.norm();
  }

  Cloud<2> cloud;
  Eulerian<2> body;
  EulerianState<2> state;
  double h;
  std::vector<Vec<2>> x, v;
  std::vector<double> rho, S;
  std::vector<Mat<2>> sigma;
};

TEST_F(PrintedEquations, HaveTheirForces) {
  const double c = body.law().sound_speed();
  double most = 0, repelled = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    Vec<2> stress = Vec<2>::Zero(), viscous = Vec<2>::Zero();
    for (Index j = 0; j < cloud.size(); ++j) {
      if (j == i) continue;
      const Vec<2> r = x[i] - x[j], g = gradient(r);
      const double f = std::pow(W(r.norm()) / W(cloud.spacing), 4), pair = body.mass()[i] * body.mass()[j];
      const Mat<2> here = (sigma[i] - 0.3 * f * positive_part(sigma[i])) / (rho[i] * rho[i] * S[i]);
      const Mat<2> there = (sigma[j] - 0.3 * f * positive_part(sigma[j])) / (rho[j] * rho[j] * S[j]);
      stress += pair * (here * g - there * gradient(-r));
      repelled += (pair * 0.3 * f / (rho[i] * rho[i] * S[i]) * positive_part(sigma[i]) * g).norm();
      const double opening = (v[i] - v[j]).dot(r), phi = h * opening / r.squaredNorm();
      if (opening < 0) viscous += pair * (2 * c - phi) * phi / (0.5 * (rho[i] + rho[j])) * g;
    }
    most = std::max(most, stress.norm());
    ASSERT_NEAR((vector_at<2>(state.force, i) - stress).norm(), 0, 1e-10 * most) << i;
    ASSERT_NEAR((vector_at<2>(state.viscous, i) - viscous).norm(), 0, 1e-12 * (1 + viscous.norm())) << i;
  }
  EXPECT_GT(repelled, most);  // the artificial stress is no small thing here
}

TEST_F(PrintedEquations, SpreadTheDensity) {
  std::vector<double> rate;
  for (Index i = 0; i < cloud.size(); ++i) {
    double sum = 0;
    for (Index j = 0; j < cloud.size(); ++j)
      if (j != i) {
        const Vec<2> apart = x[j] - x[i];
        const Vec<2> diffusion = 2 * 0.01 * h * body.law().sound_speed() * (rho[j] - rho[i]) / rho[i] *
                                 apart / apart.squaredNorm();
        sum += body.mass()[j] / rho[j] * diffusion.dot(gradient(-apart));
      }
    rate.push_back(rho[i] * sum);
  }
  const double dt = 1e-9;
  const std::vector<Mat<2>> L = body.velocity_gradients();
  ASSERT_FALSE(body.advance(state, dt));
  double most = 0;
  for (const double r : rate) most = std::max(most, std::abs(r));
  for (Index i = 0; i < cloud.size(); ++i)  // round-off of a density of 1000 over dt: 1e-13 * 1e3/1e-9
    ASSERT_NEAR((state.density[0][i] - rho[i]) / dt + rho[i] * L[i].trace(), rate[i], 1e-3 * most + 1e-3)
        << i;
}

}  // namespace
}  // namespace plumb::testing
