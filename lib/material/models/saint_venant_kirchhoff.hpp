#pragma once
#include <string_view>

#include "lib/material/invariants.hpp"

namespace plumb {

/// Saint Venant-Kirchhoff: W = lambda/2 (tr E)^2 + mu E:E with Green's strain E = (F^T F - I)/2. THEORY
/// (4.8).
///   P = F S,  S = lambda tr E I + 2 mu E
/// For large rotations and small strains: it softens under compression and has no force left at J = 0. Plane
/// strain in 2D.
struct SaintVenantKirchhoff {
  static constexpr std::string_view name = "saint-venant-kirchhoff";
  double lame;   ///< lambda [Pa]
  double shear;  ///< mu [Pa]

  explicit SaintVenantKirchhoff(const Elastic& e) : lame(e.lame()), shear(e.shear_modulus()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    const Mat<d, T> E = strain<d, T>(F);
    T square = T(0);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) square = square + E(a, b) * E(a, b);
    const T t = trace<d, T>(E);
    return T(0.5 * lame) * t * t + T(shear) * square;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    const Mat<d, T> E = strain<d, T>(F), FE = product<d, T>(F, E);
    const T pressure = T(lame) * trace<d, T>(E);
    Mat<d, T> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = pressure * F(a, b) + T(2 * shear) * FE(a, b);
    return P;
  }

 private:
  template <int d, class T>
  static Mat<d, T> strain(const Mat<d, T>& F) {
    Mat<d, T> E = right_cauchy_green<d, T>(F);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) E(a, b) = T(0.5) * (E(a, b) - T(a == b ? 1.0 : 0.0));
    return E;
  }
  template <int d, class T>
  static T trace(const Mat<d, T>& E) {
    T sum = T(0);
    for (int a = 0; a < d; ++a) sum = sum + E(a, a);
    return sum;
  }
};

}  // namespace plumb
