#pragma once
#include <array>
#include <cmath>

namespace plumb::mms {

/// Second-order jet: a value, its n first and n (n + 1) / 2 second partial derivatives. Products and
/// functions follow Leibniz and the chain rule; nothing is truncated, so the derivatives are exact to
/// round-off.
template <int n>
struct Jet {
  static constexpr int pairs = n * (n + 1) / 2;
  double value = 0;
  std::array<double, n> slope{};
  std::array<double, pairs> curve{};  ///< d2/dx_i dx_j for i <= j, row by row

  Jet() = default;
  Jet(double v) : value(v) {}  // NOLINT: constants mix with jets as numbers do
  /// The k-th independent variable.
  static Jet variable(double v, int k) {
    Jet x(v);
    x.slope[static_cast<std::size_t>(k)] = 1;
    return x;
  }
  /// d2/dx_i dx_j.
  double second(int i, int j) const {
    if (i > j) std::swap(i, j);
    const int at = i * n - i * (i - 1) / 2 + (j - i);
    return curve[static_cast<std::size_t>(at)];
  }
  /// f(x) for a function with value f and derivatives df, ddf at x.value.
  Jet chain(double f, double df, double ddf) const {
    Jet out(f);
    for (int k = 0; k < n; ++k) out.slope[k] = df * slope[k];
    for (int i = 0, m = 0; i < n; ++i)
      for (int j = i; j < n; ++j, ++m) out.curve[m] = df * curve[m] + ddf * slope[i] * slope[j];
    return out;
  }

  Jet& operator+=(const Jet& y) { return *this = *this + y; }
  Jet& operator-=(const Jet& y) { return *this = *this - y; }
  Jet& operator*=(const Jet& y) { return *this = *this * y; }

  friend Jet operator-(const Jet& x) { return x.chain(-x.value, -1, 0); }
  friend Jet operator+(const Jet& x, const Jet& y) {
    Jet out(x.value + y.value);
    for (int k = 0; k < n; ++k) out.slope[k] = x.slope[k] + y.slope[k];
    for (int m = 0; m < pairs; ++m) out.curve[m] = x.curve[m] + y.curve[m];
    return out;
  }
  friend Jet operator-(const Jet& x, const Jet& y) { return x + (-y); }
  friend Jet operator*(double a, const Jet& x) { return x.chain(a * x.value, a, 0); }
  friend Jet operator*(const Jet& x, double a) { return a * x; }
  friend Jet operator*(const Jet& x, const Jet& y) {
    Jet out(x.value * y.value);
    for (int k = 0; k < n; ++k) out.slope[k] = x.slope[k] * y.value + x.value * y.slope[k];
    for (int i = 0, m = 0; i < n; ++i)
      for (int j = i; j < n; ++j, ++m)
        out.curve[m] =
            x.curve[m] * y.value + x.slope[i] * y.slope[j] + x.slope[j] * y.slope[i] + x.value * y.curve[m];
    return out;
  }
  friend Jet operator/(const Jet& x, const Jet& y) {
    const double inverse = 1 / y.value;
    return x * y.chain(inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
  }
  friend bool operator<(const Jet& x, const Jet& y) { return x.value < y.value; }
  friend bool operator>(const Jet& x, const Jet& y) { return x.value > y.value; }

  friend Jet sqrt(const Jet& x) {
    const double root = std::sqrt(x.value);
    return x.chain(root, 0.5 / root, -0.25 / (root * x.value));
  }
  friend Jet exp(const Jet& x) {
    const double e = std::exp(x.value);
    return x.chain(e, e, e);
  }
  friend Jet log(const Jet& x) { return x.chain(std::log(x.value), 1 / x.value, -1 / (x.value * x.value)); }
  friend Jet sin(const Jet& x) {
    const double s = std::sin(x.value), c = std::cos(x.value);
    return x.chain(s, c, -s);
  }
  friend Jet cos(const Jet& x) {
    const double s = std::sin(x.value), c = std::cos(x.value);
    return x.chain(c, -s, -c);
  }
  friend Jet pow(const Jet& x, double p) {
    const double power = std::pow(x.value, p);
    return x.chain(power, p * power / x.value, p * (p - 1) * power / (x.value * x.value));
  }
};

}  // namespace plumb::mms
