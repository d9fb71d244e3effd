#pragma once
#include <string_view>

#include "lib/core/scalar.hpp"
#include "lib/material/invariants.hpp"
#include "lib/material/law.hpp"

namespace plumb {

/// Nearly incompressible Mooney-Rivlin rubber; plane strain in 2D. THEORY (4.4), (4.5).
///   W = c1 (J^-2/3 I1 - 3) + c2 (J^-4/3 I2 - 3) + kappa/2 (J - 1)^2
///   P = 2 c1 J^-2/3 (F - I1/(3 J) cof F) + 2 c2 J^-4/3 (I1 F - F C - 2 I2/(3 J) cof F) + kappa (J - 1) cof F
/// with I1 = tr C, I2 = (I1^2 - tr C^2)/2, C = F^T F, mu = 2 (c1 + c2). It is not polyconvex: J^-4/3 I2 is
/// not convex in (cof F, J). `polyconvex` is the law that is.
struct MooneyRivlin {
  static constexpr std::string_view name = "mooney-rivlin";
  struct Parameters {
    double ratio = 0.25;  ///< c2/c1; 1/4 is usual for vulcanised rubber

    template <class Visit>
    void fields(Visit&& visit) {
      visit(LawParameter{"ratio", quantity::number, "c2/c1", Sign::not_negative}, ratio);
    }
  };
  double c1, c2;  ///< [Pa]
  double bulk;    ///< kappa [Pa]

  MooneyRivlin(const Elastic& e, const Parameters& p)
      : c1(0.5 / (1 + p.ratio) * e.shear_modulus()),
        c2(0.5 * p.ratio / (1 + p.ratio) * e.shear_modulus()),
        bulk(e.bulk_modulus()) {}
  explicit MooneyRivlin(const Elastic& e) : MooneyRivlin(e, Parameters()) {}

  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J), square = j * j;
    const T I1 = first_invariant<d, T>(F), dilation = J - T(1);
    const T I2 = second_invariant<d, T>(right_cauchy_green<d, T>(F), I1);
    return T(c1) * (square * I1 - T(3)) + T(c2) * (square * square * I2 - T(3)) +
           T(0.5 * bulk) * dilation * dilation;
  }

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    const Mat<d, T> cof = cofactor<d, T>(F), C = right_cauchy_green<d, T>(F), FC = product<d, T>(F, C);
    const T J = determinant<d, T>(F);
    const T j = reciprocal_cbrt(J), square = j * j, inverse = square * j;  // 1/J = j^3 spares the division
    const T I1 = first_invariant<d, T>(F), I2 = second_invariant<d, T>(C, I1);
    const T first = T(2 * c1) * square, second = T(2 * c2) * (square * square);
    const T pressure = T(bulk) * (J - T(1)) - (first * I1 + T(2) * (second * I2)) * T(1.0 / 3) * inverse;
    const T stretch = first + second * I1;
    Mat<d, T> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) P(a, b) = pressure * cof(a, b) + stretch * F(a, b) - second * FC(a, b);
    return P;
  }
};

}  // namespace plumb
