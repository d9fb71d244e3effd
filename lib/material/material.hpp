#pragma once
#include <cmath>
#include <concepts>
#include <string_view>

#include "lib/core/types.hpp"

namespace plumb {

/// Isotropic elastic constants of the small-strain limit, THEORY (4.1), and the reference density.
struct Elastic {
  double young;    ///< E [Pa]
  double poisson;  ///< nu, dimensionless
  double density;  ///< rho_0 [kg/m^3]

  double shear_modulus() const { return young / (2 * (1 + poisson)); }     ///< mu [Pa]
  double bulk_modulus() const { return young / (3 * (1 - 2 * poisson)); }  ///< kappa [Pa], three-dimensional
  double lame() const { return bulk_modulus() - 2.0 / 3 * shear_modulus(); }  ///< lambda [Pa]
  /// Speed of pressure waves C_p^Lin of (32) [m/s].
  double wave_speed() const { return std::sqrt((lame() + 2 * shear_modulus()) / density); }
  double shear_wave_speed() const { return std::sqrt(shear_modulus() / density); }  ///< [m/s]
};

/// A hyperelastic material: energy density W(F) [Pa] and first Piola-Kirchhoff stress P = dW/dF [Pa], for any
/// scalar type with arithmetic and reciprocal_cbrt (double, complex, autodiff, Pack). In 2D the strain is
/// plane: F_33 = 1. A new material is one file in models/ with a constructor from Elastic.
template <class M, int d>
concept MaterialModel = std::constructible_from<M, Elastic> && requires(const M& m, const Mat<d>& F) {
  { M::name } -> std::convertible_to<std::string_view>;
  { m.energy(F) } -> std::convertible_to<double>;
  { m.first_piola(F) } -> std::convertible_to<Mat<d>>;
};

/// Determinant, for any scalar type.
template <int d, class T>
T determinant(const Mat<d, T>& F) {
  if constexpr (d == 1)
    return F(0, 0);
  else if constexpr (d == 2)
    return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
  else
    return F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) -
           F(0, 1) * (F(1, 0) * F(2, 2) - F(1, 2) * F(2, 0)) +
           F(0, 2) * (F(1, 0) * F(2, 1) - F(1, 1) * F(2, 0));
}

/// Cofactor matrix J F^-T, without division; for any scalar type.
template <int d, class T>
Mat<d, T> cofactor(const Mat<d, T>& F) {
  Mat<d, T> C;
  if constexpr (d == 1) {
    C(0, 0) = T(1);
  } else if constexpr (d == 2) {
    C(0, 0) = F(1, 1);
    C(0, 1) = -F(1, 0);
    C(1, 0) = -F(0, 1);
    C(1, 1) = F(0, 0);
  } else {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
        C(a, b) = F(a1, b1) * F(a2, b2) - F(a1, b2) * F(a2, b1);
      }
  }
  return C;
}

/// F : F of the three-dimensional deformation gradient: the directions that the dimension leaves out count 1
/// each.
template <int d, class T>
T first_invariant(const Mat<d, T>& F) {
  T sum = T(3 - d);
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) sum = sum + F(a, b) * F(a, b);
  return sum;
}

}  // namespace plumb
