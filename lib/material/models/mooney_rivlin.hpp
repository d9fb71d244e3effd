#pragma once
#include <string_view>

#include "plumbline/core/scalar.hpp"
#include "plumbline/material/material.hpp"

namespace plumb {

/// Nearly incompressible Mooney-Rivlin rubber; plane strain in 2D. THEORY (4.4), (4.5).
///   W = c1 (J^-2/3 I1 - 3) + c2 (J^-4/3 I2 - 3) + kappa/2 (J - 1)^2,  I1 = tr C, I2 = (I1^2 - tr C^2)/2, C =
///   F^T F P = 2 c1 J^-2/3 (F - I1/(3 J) cof F) + 2 c2 J^-4/3 (I1 F - F C - 2 I2/(3 J) cof F) + kappa (J - 1)
///   cof F
/// with mu = 2 (c1 + c2) and c2 = c1/4, which is usual for vulcanised rubber.
struct MooneyRivlin {
  static constexpr std::string_view name = "mooney-rivlin";
  double c1, c2;  ///< [Pa]
  double bulk;    ///< kappa [Pa]

  explicit MooneyRivlin(const Elastic& e)
      : c1(0.4 * e.shear_modulus()), c2(0.1 * e.shear_modulus()), bulk(e.bulk_modulus()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J), square = j * j;
    const T I1 = first_invariant<d, T>(F), dilation = J - T(1);
    return T(c1) * (square * I1 - T(3)) + T(c2) * (square * square * second_invariant<T, d>(F, I1) - T(3)) +
           T(0.5 * bulk) * dilation * dilation;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    const Eigen::Matrix<T, d, d> cof = cofactor<d, T>(F);
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J), square = j * j, inverse = square * j;  // 1/J = j^3 spares the division
    const T I1 = first_invariant<d, T>(F), I2 = second_invariant<T, d>(F, I1);
    const T first = T(2 * c1) * square, second = T(2 * c2) * (square * square);
    const T pressure = T(bulk) * (J - T(1)) - (first * I1 + T(2) * (second * I2)) * T(1.0 / 3) * inverse;
    const T stretch = first + second * I1;
    const Eigen::Matrix<T, d, d> C = right_cauchy_green<T, d>(F);
    Eigen::Matrix<T, d, d> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) {
        T bent = T(0);
        for (int c = 0; c < d; ++c) bent = bent + F(a, c) * C(c, b);
        P(a, b) = pressure * cof(a, b) + stretch * F(a, b) - second * bent;
      }
    return P;
  }

 private:
  template <class T, int d>
  static Eigen::Matrix<T, d, d> right_cauchy_green(const Eigen::Matrix<T, d, d>& F) {
    Eigen::Matrix<T, d, d> C;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) {
        C(a, b) = T(0);
        for (int c = 0; c < d; ++c) C(a, b) = C(a, b) + F(c, a) * F(c, b);
      }
    return C;
  }
  /// The directions that the dimension leaves out have C = 1.
  template <class T, int d>
  static T second_invariant(const Eigen::Matrix<T, d, d>& F, const T& I1) {
    const Eigen::Matrix<T, d, d> C = right_cauchy_green<T, d>(F);
    T square = T(3 - d);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) square = square + C(a, b) * C(a, b);
    return T(0.5) * (I1 * I1 - square);
  }
};

}  // namespace plumb
