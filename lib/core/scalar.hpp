#pragma once
#include <cmath>
#include <complex>

namespace plumb {

/// x^(-1/3). Found by argument-dependent lookup for other scalar types (Pack has its own in core/pack.hpp).
inline double reciprocal_cbrt(double x) {
  return 1 / std::cbrt(x);
}
inline long double reciprocal_cbrt(long double x) {
  return 1 / std::cbrt(x);
}

/// The principal branch, as complex-step derivatives need it.
template <class R>
std::complex<R> reciprocal_cbrt(const std::complex<R>& x) {
  return std::pow(x, R(-1) / R(3));
}

/// Any other scalar type that brings its own pow (autodiff).
template <class T>
T reciprocal_cbrt(const T& x) {
  return pow(x, -1.0 / 3);
}

}  // namespace plumb
