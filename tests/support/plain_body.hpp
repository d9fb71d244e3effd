#pragma once
#include <Eigen/LU>
#include <functional>
#include <vector>

#include "lib/material/material.hpp"
#include "tests/support/plain_table.hpp"

namespace plumb::test {

/// A body as nobody would run it: every sum over all particles, every formula as it is derived rather than as
/// the library evaluates it. What the library finds for any combination of options must be the same numbers.
template <int d>
class PlainBody {
 public:
  using Vectors = std::vector<Vec<d>>;
  using Stress = std::function<Mat<d>(const Mat<d>&)>;  ///< P(F) [Pa]

  PlainBody(const Cloud<d>& cloud, const PlainChoices& choices, const Elastic& elastic)
      : t_(cloud, choices), elastic_(elastic) {}

  Index size() const { return t_.size(); }

  /// F of particle i: one and the gradient of the displacement.
  Mat<d> deformation(Index i, const Vectors& u) const {
    Mat<d> F = Mat<d>::Zero();
    for (std::size_t n = 0; n < t_.seen.size(); ++n)
      F += (t_.place(n, u) - t_.place(i, u)) * t_.rows[i].stencil[n].transpose();
    return F;
  }

  /// k_ij |x_ij - F_i X_ij|^2 / 2 of all bonds between particles [J]. THEORY (12.1).
  double hourglass_energy(const Vectors& u) const {
    double sum = 0;
    for (Index i = 0; i < size() && t_.choices.hourglass; ++i)
      for (Index j = 0; j < size(); ++j) sum += 0.5 * spring(i, j) * unexplained(i, j, u).squaredNorm();
    return sum;
  }

  /// Force per unit volume of every particle [N/m^d], without supports.
  Vectors forces(const Vectors& u, const Vectors& v, const Stress& stress) const {
    std::vector<Mat<d>> P;
    for (Index i = 0; i < size(); ++i) P.push_back(stress(deformation(i, u)));
    Vectors f(size(), Vec<d>::Zero());
    if (t_.choices.hourglass) add_hourglass(u, P, f);
    t_.choices.momentum == "adjoint" ? add_adjoint(P, f) : add_symmetrised(P, f);
    if (t_.choices.jst) add_jst(v, f);
    if (t_.choices.projection) project(u, f);
    return f;
  }

 private:
  /// -1/V_i times the derivative of sum V W(F) with respect to x_i: (5.3), and (10.7) where images move with
  /// their particles.
  void add_adjoint(const std::vector<Mat<d>>& P, Vectors& f) const {
    for (Index k = 0; k < size(); ++k)
      for (std::size_t n = 0; n < t_.seen.size(); ++n) {
        const Vec<d> pull = t_.cloud.V[k] * P[k] * t_.rows[k].stencil[n];
        const Index j = t_.seen[n].real;
        f[k] += pull / t_.cloud.V[k];
        f[j] -= t_.seen[n].signs.cwiseProduct(pull) / t_.cloud.V[j];
      }
  }

  /// (22): sum V_j (P_i + P_j)/2 (grad W_j(X_i) - grad W_i(X_j)), with R P_j R for images.
  void add_symmetrised(const std::vector<Mat<d>>& P, Vectors& f) const {
    for (Index i = 0; i < size(); ++i)
      for (std::size_t n = 0; n < t_.seen.size(); ++n) {
        if (n == static_cast<std::size_t>(i)) continue;
        const Index j = t_.seen[n].real;
        const auto R = t_.seen[n].signs.asDiagonal();
        const Vec<d> way =
            t_.rows[i].slope[n] - t_.cloud.V[j] / t_.cloud.V[i] * (R * t_.rows[j].slope[t_.back(i, n)]);
        f[i] += 0.5 * (P[i] + Mat<d>(R * P[j] * R)) * way;
      }
  }

  double spring(Index i, Index j) const {
    const double r = (t_.cloud.X[j] - t_.cloud.X[i]).norm();
    if (r == 0 || r >= t_.kernel.support * t_.h * (1 - 1e-12)) return 0;
    double sum = 0;
    for (Index k = 0; k < size(); ++k)
      sum += t_.cloud.V[k] * t_.kernel.w((t_.cloud.X[k] - t_.cloud.X[i]).norm() / t_.h);
    return *t_.choices.hourglass * elastic_.shear_modulus() * t_.cloud.V[i] * t_.cloud.V[j] *
           t_.kernel.w(r / t_.h) / sum / (r * r);
  }
  Vec<d> unexplained(Index i, Index j, const Vectors& u) const {
    return t_.place(j, u) - t_.place(i, u) - deformation(i, u) * (t_.cloud.X[j] - t_.cloud.X[i]);
  }

  /// Derivative of the energy at fixed F goes to the force, that with respect to F to the stress. (12.2).
  void add_hourglass(const Vectors& u, std::vector<Mat<d>>& P, Vectors& f) const {
    for (Index i = 0; i < size(); ++i)
      for (Index j = 0; j < size(); ++j) {
        const double k = spring(i, j);
        if (k == 0) continue;
        const Vec<d> pull = k * unexplained(i, j, u);
        f[i] += pull / t_.cloud.V[i];
        f[j] -= pull / t_.cloud.V[j];
        P[i] -= pull * (t_.cloud.X[j] - t_.cloud.X[i]).transpose() / t_.cloud.V[i];
      }
  }

  /// (6.1): eta2 C h lap' p - eta4 C h^3 lap' lap p.
  void add_jst(const Vectors& v, Vectors& f) const {
    const double C = elastic_.wave_speed(), rho = elastic_.density;
    const Vectors inner = laplacian(v, false), second = laplacian(v, true), fourth = laplacian(inner, true);
    for (Index i = 0; i < size(); ++i)
      f[i] +=
          rho * C *
          (t_.choices.jst->eta2 * t_.h * second[i] - t_.choices.jst->eta4 * std::pow(t_.h, 3) * fourth[i]);
  }
  Vectors laplacian(const Vectors& q, bool outer) const {
    Vectors sum(size(), Vec<d>::Zero());
    for (Index i = 0; i < size(); ++i)
      for (std::size_t n = 0; n < t_.seen.size(); ++n) {
        if (n == static_cast<std::size_t>(i)) continue;
        const double there = t_.rows[i].laplace[n], here = t_.rows[t_.seen[n].real].laplace[t_.back(i, n)],
                     V = t_.volume(n);
        const Vec<d> other = t_.seen[n].signs.cwiseProduct(q[t_.seen[n].real]);
        if (outer && t_.choices.jst->transpose)
          sum[i] += V * (here * other - there * q[i]);  // V^-1 L^T V, THEORY (6.4)
        else
          sum[i] += V * (outer ? 0.5 * (there + here) : there) * (other - q[i]);
      }
    return sum;
  }

  /// f + l + w x: the unknowns from sum V f = 0 and sum V x (x-product) f = 0, all of them in one system.
  /// (5.4).
  void project(const Vectors& u, Vectors& f) const {
    constexpr int turns = d == 2 ? 1 : 3;
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(d + turns, d * size());  // constraints: B f = 0
    Eigen::VectorXd all(d * size()), V(d * size());
    for (Index i = 0; i < size(); ++i) {
      const Vec<d> x = t_.place(i, u);
      for (int k = 0; k < d; ++k) {
        all[d * i + k] = f[i][k], V[d * i + k] = t_.cloud.V[i];
        B(k, d * i + k) = t_.cloud.V[i];
      }
      for (int t = 0; t < turns; ++t) {  // component a of the torque: x_b f_c - x_c f_b
        const int b = d == 2 ? 0 : (t + 1) % 3, c = d == 2 ? 1 : (t + 2) % 3;
        B(d + t, d * i + c) += t_.cloud.V[i] * x[b];
        B(d + t, d * i + b) -= t_.cloud.V[i] * x[c];
      }
    }
    const Eigen::MatrixXd weighted = V.cwiseInverse().asDiagonal() * B.transpose();
    all -= weighted * (B * weighted).fullPivLu().solve(B * all);
    for (Index i = 0; i < size(); ++i) f[i] = all.segment<d>(d * i);
  }

  PlainTable<d> t_;
  Elastic elastic_;
};

}  // namespace plumb::test
