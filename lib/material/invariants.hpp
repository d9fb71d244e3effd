#pragma once
#include "lib/material/material.hpp"

namespace plumb {

/// C = F^T F, for any scalar type.
template <int d, class T>
Mat<d, T> right_cauchy_green(const Mat<d, T>& F) {
  Mat<d, T> C;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) {
      C(a, b) = T(0);
      for (int c = 0; c < d; ++c) C(a, b) = C(a, b) + F(c, a) * F(c, b);
    }
  return C;
}

/// I2 = (I1^2 - C : C)/2 of the three-dimensional C: the directions that the dimension leaves out have C = 1.
/// It is cof F : cof F.
template <int d, class T>
T second_invariant(const Mat<d, T>& C, const T& I1) {
  T square = T(3 - d);
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) square = square + C(a, b) * C(a, b);
  return T(0.5) * (I1 * I1 - square);
}

/// F C, for any scalar type.
template <int d, class T>
Mat<d, T> product(const Mat<d, T>& F, const Mat<d, T>& C) {
  Mat<d, T> FC;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) {
      FC(a, b) = T(0);
      for (int c = 0; c < d; ++c) FC(a, b) = FC(a, b) + F(a, c) * C(c, b);
    }
  return FC;
}

}  // namespace plumb
