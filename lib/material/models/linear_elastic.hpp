#pragma once
#include <string_view>

#include "lib/material/material.hpp"

namespace plumb {

/// Linear elasticity: W = lambda/2 (tr e)^2 + mu e:e with the small strain e = (F + F^T)/2 - I. THEORY (4.9).
///   P = lambda tr e I + 2 mu e
/// For small strains and small rotations only: it is not objective, a rotation by the angle a acts as a
/// strain of 1 - cos a. Plane strain in 2D.
struct LinearElastic {
  static constexpr std::string_view name = "linear-elastic";
  static constexpr bool objective = false;
  double lame;   ///< lambda [Pa]
  double shear;  ///< mu [Pa]

  explicit LinearElastic(const Elastic& e) : lame(e.lame()), shear(e.shear_modulus()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    T trace(0), square(0);
    for (int a = 0; a < d; ++a) {
      trace = trace + (F(a, a) - T(1));
      for (int b = 0; b < d; ++b) {
        const T strain = T(0.5) * (F(a, b) + F(b, a)) - T(a == b ? 1.0 : 0.0);
        square = square + strain * strain;
      }
    }
    return T(0.5 * lame) * trace * trace + T(shear) * square;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    Mat<d, T> P;
    T trace(0);
    for (int a = 0; a < d; ++a) trace = trace + F(a, a) - T(1);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = T(shear) * (F(a, b) + F(b, a));
    for (int a = 0; a < d; ++a) P(a, a) = P(a, a) + T(lame) * trace - T(2 * shear);
    return P;
  }
};

}  // namespace plumb
