#pragma once
#include <complex>

#include "lib/core/types.hpp"

namespace plumb {

/// Tangent of an elastic law at F: dP_ab/dF_ce [Pa] at row a d + b, column c d + e. By complex step (exact to
/// round-off): Im P(F + i s D) / s has no cancellation, so that s may be tiny.
template <int d, class M>
Mat<d * d> tangent_of(const M& material, const Mat<d>& F) {
  constexpr double step = 1e-100;
  Mat<d * d> tangent;
  for (int n = 0; n < d * d; ++n) {
    Mat<d, std::complex<double>> Fs = F.template cast<std::complex<double>>();
    Fs(n / d, n % d) += std::complex<double>(0, step);
    const Mat<d, std::complex<double>> P = material.first_piola(Fs);
    for (int m = 0; m < d * d; ++m) tangent(m, n) = P(m / d, m % d).imag() / step;
  }
  return tangent;
}

/// The rows and columns of a tangent in three dimensions that d dimensions have.
template <int d>
Mat<d * d> part_in(const Mat<9>& whole) {
  Mat<d * d> part;
  for (int m = 0; m < d * d; ++m)
    for (int n = 0; n < d * d; ++n) part(m, n) = whole(m / d * 3 + m % d, n / d * 3 + n % d);
  return part;
}

}  // namespace plumb
