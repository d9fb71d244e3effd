#pragma once
#include <cmath>
#include <string_view>

#include "lib/material/invariants.hpp"
#include "lib/material/material.hpp"

namespace plumb {

/// Compressible neo-Hookean rubber with a logarithm, (59) and (60) of paper 004; plane strain in 2D. THEORY
/// (4.20).
///   W = mu/2 (F:F - 3) - mu ln J + lambda/2 (ln J)^2
///   P = mu F + (lambda ln J - mu)/J cof F
/// Its energy grows without bound towards J = 0.
struct NeoHookeanLogarithmic {
  static constexpr std::string_view name = "neo-hookean-logarithmic";
  double lame;   ///< lambda [Pa]
  double shear;  ///< mu [Pa]

  explicit NeoHookeanLogarithmic(const Elastic& e) : lame(e.lame()), shear(e.shear_modulus()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    using std::log;
    const T dilation = log(determinant<d, T>(F));
    return T(0.5 * shear) * (first_invariant<d, T>(F) - T(3)) - T(shear) * dilation +
           T(0.5 * lame) * dilation * dilation;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    using std::log;
    const Mat<d, T> cof = cofactor<d, T>(F);
    const T J = determinant<d, T>(F);
    const T pressure = (T(lame) * log(J) - T(shear)) / J;
    Mat<d, T> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = T(shear) * F(a, b) + pressure * cof(a, b);
    return P;
  }
};

}  // namespace plumb
