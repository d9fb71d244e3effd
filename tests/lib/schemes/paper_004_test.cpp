// What paper 004 prints, taken literally on a small cloud with a support per particle, beside what is meant.
// The ledger (verification/claims) cites these numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/geometry/cloud.hpp"
#include "lib/kernel/kernel.hpp"

namespace plumb {
namespace {

using Vector = std::vector<Vec<2>>;

/// 6 x 5 particles, moved, with volumes and supports of their own; E = 10, nu = 0.3.
struct Printed {
  std::vector<Vec<2>> X, u, x;
  std::vector<double> V, h;
  RadialKernel<2> kernel = kernel_named<2>("quintic");
  double mu = 10 / 2.6, lambda = 10 * 0.3 / (1.3 * 0.4);

  Printed() {
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 6; ++i) {
        X.emplace_back(0.1 * (i + 0.2 * std::sin(3 * i + 5 * j)), 0.1 * (j + 0.2 * std::cos(2 * i - 3 * j)));
        u.emplace_back(0.006 * (std::sin(20 * X.back()[0]) + 5 * X.back()[1]),
                       0.06 * X.back()[0] * std::cos(15 * X.back()[1]));
        V.push_back(0.01 * (1 + 0.1 * std::sin(i + 2 * j)));
        h.push_back(0.1 * (2.4 + 0.5 * std::cos(i - j)));
      }
    move({});
  }
  std::size_t size() const { return X.size(); }
  /// x = X + u + s v.
  void move(const Vector& v, double s = 0) {
    x = X;
    for (std::size_t i = 0; i < size(); ++i) x[i] += u[i] + (v.empty() ? Vec<2>::Zero() : Vec<2>(s * v[i]));
  }
  /// V_j W'(r)/r, negative; 0 outside of the support of i. In units of h^-d, which cancel.
  double slope(std::size_t i, std::size_t j) const {
    const double r = (X[j] - X[i]).norm();
    return i == j || r >= h[i] ? 0 : V[j] * kernel.dw(r / h[i] * kernel.support) / (r * h[i]);
  }
  Mat<2> L(std::size_t i) const {
    Mat<2> sum = Mat<2>::Zero();
    for (std::size_t j = 0; j < size(); ++j) sum += slope(i, j) * (X[j] - X[i]) * (X[j] - X[i]).transpose();
    return sum;
  }
  Vec<2> c(std::size_t i, std::size_t j) const { return slope(i, j) * L(i).inverse() * (X[j] - X[i]); }
  Mat<2> F(std::size_t i) const {
    Mat<2> sum = Mat<2>::Zero();
    for (std::size_t j = 0; j < size(); ++j) sum += (x[j] - x[i]) * c(i, j).transpose();
    return sum;
  }
  /// sum V F^hg with (21), first line; m_L = tr L.
  double hourglass_energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const Mat<2> of = F(i);
      const double m = L(i).trace();
      for (std::size_t j = 0; j < size(); ++j)
        sum += V[i] * mu / m * slope(i, j) * (of * (X[j] - X[i]) - (x[j] - x[i])).squaredNorm();
    }
    return sum;
  }
  /// (21), last line.
  double last_line() const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const Mat<2> of = F(i), l = L(i);
      double springs = 0;
      for (std::size_t j = 0; j < size(); ++j) springs += slope(i, j) * (x[j] - x[i]).squaredNorm();
      sum += V[i] * mu / l.trace() * (springs - of.cwiseProduct(of * l).sum());
    }
    return sum;
  }
  /// Forces V_i (rho a) of (28) with the pair terms (27) times `sign`.
  Vector hourglass_force(double sign) const {
    Vector f(size(), Vec<2>::Zero());
    for (std::size_t i = 0; i < size(); ++i) {
      const Mat<2> of = F(i);
      const double m = L(i).trace();
      for (std::size_t j = 0; j < size(); ++j) {
        // (27): -2 mu/m_L W'/r (x_ij - F X_ij)
        const Vec<2> T = -sign * 2 * mu / m * slope(i, j) * (x[j] - x[i] - of * (X[j] - X[i]));
        f[i] += V[i] * T;
        f[j] -= V[i] * T;
      }
    }
    return f;
  }
};

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}
/// A direction that nothing spares.
Vector direction(std::size_t n, int seed) {
  Vector v;
  for (std::size_t i = 0; i < n; ++i)
    v.emplace_back(std::sin(1.7 * static_cast<double>(i) + seed),
                   std::cos(2.3 * static_cast<double>(i) * seed));
  return v;
}
/// dE/ds and d2E/ds2 of the hourglass energy, which is quadratic: differences of any width are exact.
double slope_of_energy(Printed& p, const Vector& v) {
  p.move(v, 0.1);
  const double up = p.hourglass_energy();
  p.move(v, -0.1);
  const double down = p.hourglass_energy();
  p.move({});
  return (up - down) / 0.2;
}
double curvature_of_energy(Printed& p, const Vector& v) {
  p.move(v, 0.1);
  const double up = p.hourglass_energy();
  p.move(v, -0.1);
  const double down = p.hourglass_energy();
  p.move({});
  return (up + down - 2 * p.hourglass_energy()) / 0.01;
}

TEST(Paper004, AllLinesOfTheHourglassEnergyAreEqual) {
  const Printed p;
  EXPECT_NEAR(p.hourglass_energy(), 0.0050439573059464, 1e-12);
  EXPECT_NEAR(p.last_line() / p.hourglass_energy(), 1, 1e-12);  // a difference of terms 1e3 times as large
}

/// As (28) needs it, (27) has the wrong sign: the force drives where the energy grows.
TEST(Paper004, TheHourglassForceHasTheWrongSign) {
  Printed p;
  for (const int seed : {1, 2, 3}) {
    const Vector v = direction(p.size(), seed);
    const double fall = -slope_of_energy(p, v);
    EXPECT_NEAR(dot(p.hourglass_force(1), v) / fall, -1, 1e-9) << seed;
    EXPECT_NEAR(dot(p.hourglass_force(-1), v) / fall, 1, 1e-9) << seed;
  }
}

/// (29) is the energy of a displacement, half of its second derivative.
TEST(Paper004, TheHourglassStiffnessIsHalf) {
  Printed p;
  const auto printed = [&](const Vector& v) {
    Printed moved = p;
    moved.x = v;  // (29) is (21) with the variation in place of x
    return moved.hourglass_energy();
  };
  for (const int seed : {1, 2, 3}) {
    const Vector v = direction(p.size(), seed);
    EXPECT_NEAR(printed(v) / curvature_of_energy(p, v), 0.5, 1e-9) << seed;
  }
}

/// With the support of i read as its dual support forces do not balance.
TEST(Paper004, SupportsForDualSupportsLeaveANetForce) {
  const Printed p;
  Vec<2> with_dual = Vec<2>::Zero(), without = with_dual;
  double size = 0;
  std::vector<Mat<2>> P;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Mat<2> H = p.F(i) - Mat<2>::Identity(), e = 0.5 * (H + H.transpose());
    P.push_back(p.lambda * e.trace() * Mat<2>::Identity() + 2 * p.mu * e);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec<2> exact = Vec<2>::Zero(), taken = exact;
    for (std::size_t j = 0; j < p.size(); ++j) {
      exact += p.V[i] * P[i] * p.c(i, j) - p.V[j] * P[j] * p.c(j, i);
      // only j in S_i are summed: those that see i without being seen by it are lost
      const bool seen = i != j && (p.X[j] - p.X[i]).norm() < p.h[i];
      if (seen) taken += p.V[i] * P[i] * p.c(i, j) - p.V[j] * P[j] * p.c(j, i);
    }
    with_dual += exact;
    without += taken;
    size += exact.norm();
  }
  EXPECT_LT(with_dual.norm() / size, 1e-15);
  EXPECT_GT(without.norm() / size, 1e-4);
  EXPECT_LT(without.norm() / size, 1e-2);
}

/// L of (11) with (9) is negative definite, so that the scale of the kernel and its sign cancel in (12).
TEST(Paper004, TheCorrectionIsNegativeDefinite) {
  const Printed p;
  double most = -1e9, worst = 0;
  Mat<2> A;
  A << 1.3, 0.2, -0.4, 0.9;
  Printed affine;
  for (std::size_t i = 0; i < p.size(); ++i) affine.x[i] = A * affine.X[i];
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Mat<2> l = p.L(i);
    most =
        std::max(most, 0.5 * (l.trace() + std::hypot(l(0, 0) - l(1, 1), 2 * l(0, 1))) / std::abs(l.trace()));
    worst = std::max(worst, (affine.F(i) - A).norm());
  }
  EXPECT_LT(most, -0.05);   // the larger eigenvalue
  EXPECT_LT(worst, 1e-13);  // F is exact for affine maps
}

/// L over its trace, and the weight -W' r of a neighbour over the sum of all over r^2: values of another program.
TEST(Paper004, TheWeightsOfTheHourglassEnergyHaveTheirValues) {
  const Printed p;
  const Mat<2> L = p.L(8) / p.L(8).trace();
  EXPECT_NEAR(L(0, 0), 0.44786832497249, 1e-13);
  EXPECT_NEAR(L(0, 1), -0.024215197995195, 1e-13);
  EXPECT_NEAR(p.slope(8, 9) / p.L(8).trace(), 4.419032223813, 1e-11);  // to its printed digits
}

/// P of (60) in the plane and D of (61), as printed and mended.
Mat<2> stress(const Mat<2>& F, double lambda, double mu) {
  const double J = F.determinant();
  return mu * F + (lambda * std::log(J) - mu) * F.inverse().transpose();
}
Mat<2> printed_change(const Mat<2>& F, const Mat<2>& dF, double lambda, double mu, double missing) {
  const double J = F.determinant();
  const Mat<2> cof = J * F.inverse().transpose();
  Mat<2> dcof;  // J_FF : dF; linear in the plane
  dcof << dF(1, 1), -dF(1, 0), -dF(0, 1), dF(0, 0);
  return mu * dF + (lambda * std::log(J) - missing) / J * dcof +
         (lambda - lambda * std::log(J) + mu) / (J * J) * cof.cwiseProduct(dF).sum() * cof;
}

/// (61) lacks -mu/J J_FF: at rest it is off by mu.
TEST(Paper004, TheTangentOfTheSecondLawLacksATerm) {
  const double mu = 10 / 2.6, lambda = 10 * 0.3 / (1.3 * 0.4);
  Mat<2> stretched;
  stretched << 1.2, 0.1, -0.2, 0.9;
  for (const Mat<2>& F : {Mat<2>(Mat<2>::Identity()), stretched}) {
    double off = 0, mended = 0;
    for (int n = 0; n < 4; ++n) {
      Mat<2> dF = Mat<2>::Zero();
      dF(n / 2, n % 2) = 1;
      const double s = 1e-5;
      const Mat<2> exact = (stress(F + s * dF, lambda, mu) - stress(F - s * dF, lambda, mu)) / (2 * s);
      off = std::max(off, (printed_change(F, dF, lambda, mu, 0) - exact).cwiseAbs().maxCoeff());
      mended = std::max(mended, (printed_change(F, dF, lambda, mu, mu) - exact).cwiseAbs().maxCoeff());
    }
    EXPECT_NEAR(off, mu / F.determinant(), 1e-6);
    EXPECT_LT(mended, 1e-6);  // differences of second order, of steps of 1e-5
  }
}

/// (44) is no function of F^T F: a turn by 0.1 rad strains it.
TEST(Paper004, TheLinearLawFeelsATurn) {
  const double mu = 10 / 2.6, lambda = 10 * 0.3 / (1.3 * 0.4);
  Mat<2> turn;
  turn << std::cos(0.1), -std::sin(0.1), std::sin(0.1), std::cos(0.1);
  const Mat<2> e = 0.5 * (turn + turn.transpose()) - Mat<2>::Identity();
  EXPECT_NEAR(0.5 * lambda * e.trace() * e.trace() + mu * e.squaredNorm(),
              (2 * lambda + 2 * mu) * std::pow(1 - std::cos(0.1), 2), 1e-12);
  EXPECT_GT(e.norm(), 7e-3);
}

}  // namespace
}  // namespace plumb
