#pragma once
#include <array>

#include "lib/core/roots.hpp"
#include "lib/material/material.hpp"

/// Algebra of 3 x 3 tensors for any scalar type.
namespace plumb {

/// The tensor cross product (A x B)_iI = e_ijk e_IJK A_jJ B_kK of paper 003; cof F = F x F / 2.
template <class T>
Mat<3, T> tensor_cross(const Mat<3, T>& A, const Mat<3, T>& B) {
  Mat<3, T> C;
  for (int i = 0; i < 3; ++i)
    for (int I = 0; I < 3; ++I) {
      const int j = (i + 1) % 3, k = (i + 2) % 3, J = (I + 1) % 3, K = (I + 2) % 3;
      C(i, I) = A(j, J) * B(k, K) - A(j, K) * B(k, J) + A(k, K) * B(j, J) - A(k, J) * B(j, K);
    }
  return C;
}

/// A tensor of d dimensions as one of three, with `rest` on the diagonal where d ends.
template <int d, class T>
Mat<3, T> in_3d(const Mat<d, T>& A, const T& rest) {
  Mat<3, T> B;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) B(a, b) = a < d && b < d ? A(a % d, b % d) : (a == b ? rest : T(0));
  return B;
}

/// A : B.
template <int d, class T>
T double_dot(const Mat<d, T>& A, const Mat<d, T>& B) {
  T sum(0);
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) sum += A(a, b) * B(a, b);
  return sum;
}

/// A B^T.
template <int d, class T>
Mat<d, T> times_transpose(const Mat<d, T>& A, const Mat<d, T>& B) {
  Mat<d, T> C;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) {
      C(a, b) = A(a, 0) * B(b, 0);
      for (int c = 1; c < d; ++c) C(a, b) += A(a, c) * B(b, c);
    }
  return C;
}

/// F^-T.
template <int d, class T>
Mat<d, T> inverse_transpose(const Mat<d, T>& F) {
  const T inverse = T(1) / determinant<d, T>(F);
  Mat<d, T> C = cofactor<d, T>(F);
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) C(a, b) = C(a, b) * inverse;
  return C;
}

/// cos(acos(s)/3) of s in [-1, 1]: with x = (1 - sqrt((1 + s)/2))/2 it is the hypergeometric series
/// 2F1(2/3, -2/3; 1/2; x), whose terms fall at least as 2^-n.
template <class T>
T cosine_of_third(const T& s) {
  constexpr int terms = 24;  // 2^-24 and n^-3/2: 1e-9, enough for a wave speed
  using std::sqrt;
  const T x = T(0.5) * (T(1) - sqrt(T(0.5) * (T(1) + s)));
  T sum(1);
  for (int n = terms; n > 0; --n) {
    const double ratio = (n - 1 + 2.0 / 3) * (n - 1 - 2.0 / 3) / ((n - 0.5) * n);
    sum = T(1) + T(ratio) * x * sum;
  }
  return sum;
}

/// Least principal stretch of the 3 x 3 tensor F, which is 1 in the directions that d leaves out. Stretches
/// that nearly agree lose half of the digits, which a wave speed can bear.
template <class T>
T lesser(const T& a, const T& b) {
  return min(a, b);
}
inline double lesser(double a, double b) {
  return std::min(a, b);
}
template <int d, class T>
T least_stretch(const Mat<d, T>& F) {
  using std::sqrt;
  if constexpr (d == 1) return lesser(F(0, 0), T(1));
  const Mat<d, T> C = times_transpose<d, T>(F, F);
  if constexpr (d == 2) {
    const T half = T(0.5) * (C(0, 0) + C(1, 1)), off = T(0.5) * (C(0, 0) - C(1, 1));
    const T most = sqrt(half + sqrt(off * off + C(0, 1) * C(0, 1)));
    return lesser(determinant<2, T>(F) / most, T(1));
  } else if constexpr (d == 3) {
    Mat<3, T> A = C;
    const T mean = (C(0, 0) + C(1, 1) + C(2, 2)) * T(1.0 / 3);
    for (int a = 0; a < 3; ++a) A(a, a) = C(a, a) - mean;
    const T square = double_dot<3, T>(A, A) * T(1.0 / 6), p = sqrt(square);
    const T s = T(-0.5) * determinant<3, T>(A) / (square * p + T(1e-280));  // C = mean I has s = 0
    const T inside = -lesser(-lesser(s, T(1)), T(1));
    const T least = mean - T(2) * p * cosine_of_third(inside);
    return sqrt(-lesser(-least, T(-1e-12) * mean));  // rounding may leave it below zero
  }
}

}  // namespace plumb
