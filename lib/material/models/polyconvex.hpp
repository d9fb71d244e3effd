#pragma once
#include <numbers>
#include <string_view>

#include "lib/core/roots.hpp"
#include "lib/core/scalar.hpp"
#include "lib/material/invariants.hpp"
#include "lib/material/law.hpp"

namespace plumb {

/// Polyconvex Mooney-Rivlin rubber, (5) of paper 003: convex in F, H = cof F and J. THEORY (4.6), (4.7).
///   W = zeta J^-2/3 F:F + xi J^-2 (H:H)^3/2 + kappa/2 (J - 1)^2 - 3 zeta - 3 sqrt3 xi
///   P = 2 zeta J^-2/3 (F - I1/(3 J) cof F) + 3 xi J^-2 I2^1/2 (I1 F - F C - 2 I2/(3 J) cof F)
///       + kappa (J - 1) cof F
/// with I1 = F:F, I2 = H:H, C = F^T F and 2 zeta + 3 sqrt3 xi = mu. Plane strain in 2D.
struct Polyconvex {
  static constexpr std::string_view name = "polyconvex";
  struct Parameters {
    double share = 0;  ///< s = 3 sqrt3 xi/mu; 0 is the neo-Hookean law, which paper 003 uses

    template <class Visit>
    void fields(Visit&& visit) {
      visit(LawParameter{"share", quantity::number, "share of mu that H carries, from 0 to 1",
                         Sign::not_negative, 1},
            share);
    }
  };
  double zeta, xi;  ///< [Pa]
  double bulk;      ///< kappa [Pa]

  Polyconvex(const Elastic& e, const Parameters& p)
      : zeta(0.5 * (1 - p.share) * e.shear_modulus()),
        xi(p.share * e.shear_modulus() / (3 * std::numbers::sqrt3)),
        bulk(e.bulk_modulus()) {}
  explicit Polyconvex(const Elastic& e) : Polyconvex(e, Parameters()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    const T I1 = first_invariant<d, T>(F);
    return of_invariants(I1, second_invariant<d, T>(right_cauchy_green<d, T>(F), I1), determinant<d, T>(F));
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    using std::sqrt;
    const Mat<d, T> cof = cofactor<d, T>(F), C = right_cauchy_green<d, T>(F), FC = product<d, T>(F, C);
    const T I1 = first_invariant<d, T>(F), I2 = second_invariant<d, T>(C, I1), J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J), square = j * j, inverse = square * j;
    const T first = T(2 * zeta) * square, second = T(3 * xi) * inverse * inverse * sqrt(I2);
    const T pressure = T(bulk) * (J - T(1)) - (first * I1 + T(2) * (second * I2)) * T(1.0 / 3) * inverse;
    const T stretch = first + second * I1;
    Mat<d, T> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = pressure * cof(a, b) + stretch * F(a, b) - second * FC(a, b);
    return P;
  }

  /// What is conjugate to F, H and J [Pa], (7) to (9) of paper 003.
  template <class T>
  struct Conjugates {
    Mat<3, T> F, H;
    T J;
  };

  /// W(F, H, J) where H and J need not be those of F.
  template <class T>
  T energy(const Mat<3, T>& F, const Mat<3, T>& H, const T& J) const {
    return of_invariants(first_invariant<3, T>(F), first_invariant<3, T>(H), J);
  }

  /// dW/dF, dW/dH, dW/dJ. P = Sigma_F + Sigma_H x F + Sigma_J H.
  template <class T>
  Conjugates<T> conjugates(const Mat<3, T>& F, const Mat<3, T>& H, const T& J) const {
    using std::sqrt;
    const T j = reciprocal_cbrt(J), square = j * j, inverse = square * j;
    const T HH = first_invariant<3, T>(H), root = sqrt(HH);
    const T in_F = T(2 * zeta) * square, in_H = T(3 * xi) * inverse * inverse * root;
    Conjugates<T> sigma;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        sigma.F(a, b) = in_F * F(a, b);
        sigma.H(a, b) = in_H * H(a, b);
      }
    sigma.J =
        T(bulk) * (J - T(1)) - T(1.0 / 3) * inverse * (in_F * first_invariant<3, T>(F) + T(2) * (in_H * HH));
    return sigma;
  }

 private:
  template <class T>
  T of_invariants(const T& FF, const T& HH, const T& J) const {
    using std::sqrt;
    const T j = reciprocal_cbrt(J), square = j * j, dilation = J - T(1);
    return T(zeta) * (square * FF - T(3)) +
           T(xi) * (square * square * square * (HH * sqrt(HH)) - T(3 * std::numbers::sqrt3)) +
           T(0.5 * bulk) * dilation * dilation;
  }
};

}  // namespace plumb
