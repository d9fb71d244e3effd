#pragma once
#include <array>
#include <cmath>

namespace plumb::mms {

/// First-order forward dual number: a value and its n partial derivatives.
/// Plumbline's own, because the body force is evaluated per particle and stage and Boost.Math autodiff was
/// measured too slow for that: the numbers are in mms/README.md. The second derivation (mms/check.hpp) uses
/// none of this.
template <int n>
struct Dual {
  double value = 0;
  std::array<double, n> slope{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants mix with duals as numbers do
  /// The k-th independent variable.
  static Dual variable(double v, int k) {
    Dual x(v);
    x.slope[static_cast<std::size_t>(k)] = 1;
    return x;
  }
  /// f(x) for a function with value f and derivative df at x.value.
  Dual chain(double f, double df) const {
    Dual out(f);
    for (int k = 0; k < n; ++k) out.slope[k] = df * slope[k];
    return out;
  }

  Dual& operator+=(const Dual& y) { return *this = *this + y; }
  Dual& operator-=(const Dual& y) { return *this = *this - y; }
  Dual& operator*=(const Dual& y) { return *this = *this * y; }

  friend Dual operator-(const Dual& x) { return x.chain(-x.value, -1); }
  friend Dual operator+(const Dual& x, const Dual& y) {
    Dual out(x.value + y.value);
    for (int k = 0; k < n; ++k) out.slope[k] = x.slope[k] + y.slope[k];
    return out;
  }
  friend Dual operator-(const Dual& x, const Dual& y) {
    Dual out(x.value - y.value);
    for (int k = 0; k < n; ++k) out.slope[k] = x.slope[k] - y.slope[k];
    return out;
  }
  friend Dual operator*(const Dual& x, const Dual& y) {
    Dual out(x.value * y.value);
    for (int k = 0; k < n; ++k) out.slope[k] = x.slope[k] * y.value + x.value * y.slope[k];
    return out;
  }
  friend Dual operator/(const Dual& x, const Dual& y) {
    const double inverse = 1 / y.value;
    return x * y.chain(inverse, -inverse * inverse);
  }
  friend bool operator<(const Dual& x, const Dual& y) { return x.value < y.value; }
  friend bool operator>(const Dual& x, const Dual& y) { return x.value > y.value; }

  friend Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return x.chain(root, 0.5 / root);
  }
  friend Dual exp(const Dual& x) {
    const double e = std::exp(x.value);
    return x.chain(e, e);
  }
  friend Dual log(const Dual& x) { return x.chain(std::log(x.value), 1 / x.value); }
  friend Dual sin(const Dual& x) { return x.chain(std::sin(x.value), std::cos(x.value)); }
  friend Dual cos(const Dual& x) { return x.chain(std::cos(x.value), -std::sin(x.value)); }
  friend Dual pow(const Dual& x, double p) {
    const double power = std::pow(x.value, p);
    return x.chain(power, p * power / x.value);
  }
  /// x^(-1/3), as materials need it (core/scalar.hpp).
  friend Dual reciprocal_cbrt(const Dual& x) {
    const double root = 1 / std::cbrt(x.value);
    return x.chain(root, -root / (3 * x.value));
  }
};

}  // namespace plumb::mms
