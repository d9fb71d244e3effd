#pragma once
#include <string_view>

#include "lib/core/scalar.hpp"
#include "lib/material/material.hpp"

namespace plumb {

/// Nearly incompressible neo-Hookean rubber, (17), (18) and (47b) of paper 000; plane strain in 2D. THEORY
/// (4.2), (4.3).
///   W = mu/2 (J^-2/3 F:F - 3) + kappa/2 (J - 1)^2
///   P = kappa (J - 1) cof F + mu J^-2/3 (F - (F:F)/(3 J) cof F)
struct NeoHookean {
  static constexpr std::string_view name = "neo-hookean";
  double shear;  ///< mu [Pa]
  double bulk;   ///< kappa [Pa]

  explicit NeoHookean(const Elastic& e) : shear(e.shear_modulus()), bulk(e.bulk_modulus()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J);
    const T dilation = J - T(1);
    return T(0.5 * shear) * (j * j * first_invariant<d, T>(F) - T(3)) + T(0.5 * bulk) * dilation * dilation;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    const Eigen::Matrix<T, d, d> C = cofactor<d, T>(F);
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J);
    const T stretch = T(shear) * j * j;
    // 1/J = j^3 spares the division
    const T pressure = T(bulk) * (J - T(1)) - stretch * first_invariant<d, T>(F) * T(1.0 / 3) * (j * j * j);
    Eigen::Matrix<T, d, d> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = pressure * C(a, b) + stretch * F(a, b);
    return P;
  }
};

}  // namespace plumb
