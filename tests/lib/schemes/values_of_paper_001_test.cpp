// Numbers of paper 001 that follow from its equations by arithmetic or by sums over lattices; the ledger of claims names
// these tests.
#include <gtest/gtest.h>

#include "lib/schemes/eulerian/reference_pairs.hpp"
#include "tests/support/eulerian.hpp"

namespace plumb::testing {
namespace {

const double pi = std::acos(-1.0);

TEST(EulerianClaims, ConstantsOfThePlate) {
  const double bulk = 3.25e6, shear = 0.715e6, rho = 1000, E = soft.young, nu = soft.poisson;
  EXPECT_NEAR(E, 1.998447e6, 1);
  EXPECT_NEAR(nu, 0.397516, 1e-6);
  EXPECT_NEAR(E / (1 - nu * nu), 2.373505e6, 1);
  EXPECT_NEAR(std::sqrt(bulk / rho), 57.00877, 1e-5);
  EXPECT_NEAR(std::sqrt((bulk + 4 * shear / 3) / rho), 64.83312, 1e-5);
  // the root of cos kl cosh kl = -1, and periods of a thin plate
  const double kl = 1.875104069;
  EXPECT_NEAR(std::cos(kl) * std::cosh(kl), -1, 1e-8);
  EXPECT_NEAR(std::cos(1.875) * std::cosh(1.875), -1, 5e-4);
  const auto period = [&](double H) {
    return 2 * pi / (1.875 * 1.875 / 0.04 * H * std::sqrt(E / (1 - nu * nu) / (12 * rho)));
  };
  EXPECT_NEAR(period(0.02), 0.25415746, 1e-8);
  EXPECT_NEAR(period(0.01), 2 * period(0.02), 1e-12);
  // the amplitude v_l/omega of small deflections, over the length of the plate
  const double speed = 0.05 * std::sqrt(bulk / rho);
  EXPECT_NEAR(speed * period(0.02) / (2 * pi) / 0.2, 0.576507, 1e-6);
  EXPECT_NEAR(speed * period(0.01) / (2 * pi) / 0.2, 1.153014, 1e-6);
  EXPECT_EQ(200 * 20 + 43 * 26, 5118);
  EXPECT_EQ(400 * 20 + 83 * 26, 10158);
}

/// Sums over a lattice with cells of 1: s(k) = -sum w x sin(k x), S, and M.
template <int d>
struct LatticeSum {
  SplinePairs<d> kernel{1.3};
  double S = 0, M = 0;
  template <class Use>
  void each(Use&& use) const {
    for (int n = 0; n < (d == 3 ? 343 : 49); ++n) {
      Vec<d> x;
      for (int k = 0, rest = n; k < d; ++k, rest /= 7) x[k] = rest % 7 - 3;
      use(x);
    }
  }
  LatticeSum() {
    each([&](const Vec<d>& x) {
      const double r = x.norm();
      S += kernel.value(r);
      if (r > 0) M -= kernel(r) * x[0] * x[0];
    });
  }
  double s(double k) const {
    double sum = 0;
    each([&](const Vec<d>& x) {
      if (x.norm() > 0) sum -= kernel(x.norm()) * x[0] * std::sin(k * x[0]);
    });
    return sum;
  }
  /// Periods of a plane wave along an axis over the exact one, of the printed and of the adjoint force.
  double printed(int n) const { return 2 * pi / n / (s(2 * pi / n) / std::sqrt(M * S)); }
  double adjoint(int n) const { return 2 * pi / n / (s(2 * pi / n) / M); }
};

TEST(EulerianClaims, WavesOnALatticeHaveTheseSpeeds) {
  const LatticeSum<2> plane;
  const double of_printed[] = {1.1093209, 1.0221543, 1.0015220, 0.9964334, 0.9951656},
               of_adjoint[] = {1.1151830, 1.0275557, 1.0068144, 1.0016990, 1.0004245};
  for (int level = 0; level < 5; ++level) {
    EXPECT_NEAR(plane.printed(10 << level), of_printed[level], 1e-7) << level;
    EXPECT_NEAR(plane.adjoint(10 << level), of_adjoint[level], 1e-7) << level;
  }
  EXPECT_NEAR(plane.printed(10000), 0.9947434, 1e-6);
  EXPECT_NEAR(plane.M / plane.S, 1.01059675, 1e-8);
  const LatticeSum<3> space;
  EXPECT_NEAR(space.M / space.S, 0.99621, 5e-6);
  EXPECT_NEAR(std::sqrt(space.M / space.S), 0.9981, 5e-5);
}

TEST(EulerianClaims, WeightsOfTheKernel) {
  const SplinePairs<2> kernel(1.3);
  EXPECT_NEAR(std::pow(kernel.value(0) / kernel.value(1), 4), 23.58, 0.005);  // f^4 of (11)
  EXPECT_NEAR(kernel.value(0), 0.269, 5e-4);  // the Shepard sum of a lone particle
}

/// rms of F - I after a cycle of shapes that ends where it began, with that many references.
double drift_of_loop(Index n, int references) {
  const Cloud<2> cloud = cells<2>({n, n}, 1.0 / static_cast<double>(n));
  const double h = 1.3 * cloud.spacing;
  const auto shape = [&](double t) {
    std::vector<Vec<2>> x;
    for (const Vec<2>& X : cloud.X) {
      const Vec<2> bent(std::sin(pi * X[0]) * std::cos(2 * X[1]), std::cos(pi * X[1]) * X[0]);
      const Vec<2> twisted(X[1] * X[1], std::sin(2 * X[0] * X[1]));
      x.push_back(X + 0.15 * (std::sin(2 * pi * t) * bent + (1 - std::cos(2 * pi * t)) * twisted));
    }
    return x;
  };
  std::vector<Mat<2>> F(cloud.X.size(), Mat<2>::Identity());
  std::vector<Vec<2>> from = shape(0);
  for (int k = 1; k <= references; ++k) {
    MovingNeighbours<2> neighbours(2 * h, 0.1 * cloud.spacing);
    neighbours.update(from);
    const ReferencePairs<2> reference(from, cloud.V, neighbours.list(), SplinePairs<2>(h));
    const std::vector<Vec<2>> to = shape(static_cast<double>(k) / references);
    for (Index i = 0; i < cloud.size(); ++i) F[i] = reference.gradient(to, i) * F[i];
    from = to;
  }
  double square = 0;
  for (const Mat<2>& each : F) square += (each - Mat<2>::Identity()).squaredNorm();
  return std::sqrt(square / static_cast<double>(cloud.size()));
}

/// The product of (30) does not come back: however often the reference is made anew, and less on finer lattices.
TEST(EulerianClaims, TheProductOfReferencesDriftsOverALoop) {
  EXPECT_LT(drift_of_loop(10, 1), 1e-14);
  // by an independent program
  EXPECT_NEAR(drift_of_loop(10, 16), 0.034741770, 1e-8);
  EXPECT_NEAR(drift_of_loop(10, 64), 0.033508510, 1e-8);
  EXPECT_NEAR(drift_of_loop(10, 256), 0.033465670, 1e-8);
  EXPECT_NEAR(drift_of_loop(20, 64), 0.014804371, 1e-8);
}

}  // namespace
}  // namespace plumb::testing
