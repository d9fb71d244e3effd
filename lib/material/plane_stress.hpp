#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <limits>

#include "lib/core/roots.hpp"
#include "lib/core/scalar.hpp"
#include "lib/material/law.hpp"

namespace plumb {

/// A number with its derivative by one variable, for Newton's method; over any scalar type.
template <class T>
struct Sloped {
  T value{}, slope{};

  Sloped() = default;
  Sloped(double v) : value(v), slope(0) {}  // NOLINT: constants mix as numbers do
  Sloped(T v, T s) : value(v), slope(s) {}

  friend Sloped operator+(const Sloped& x, const Sloped& y) { return {x.value + y.value, x.slope + y.slope}; }
  friend Sloped operator-(const Sloped& x, const Sloped& y) { return {x.value - y.value, x.slope - y.slope}; }
  friend Sloped operator-(const Sloped& x) { return {-x.value, -x.slope}; }
  friend Sloped operator*(const Sloped& x, const Sloped& y) {
    return {x.value * y.value, x.slope * y.value + x.value * y.slope};
  }
  friend Sloped operator/(const Sloped& x, const Sloped& y) {
    const T quotient = x.value / y.value;
    return {quotient, (x.slope - quotient * y.slope) / y.value};
  }
  friend Sloped log(const Sloped& x) {
    using std::log;
    return {log(x.value), x.slope / x.value};
  }
  friend Sloped reciprocal_cbrt(const Sloped& x) {
    using plumb::reciprocal_cbrt;
    const T root = reciprocal_cbrt(x.value);
    return {root, T(-1.0 / 3) * (root * root) * (root * root) * x.slope};
  }
  friend Sloped sqrt(const Sloped& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    return {root, T(0.5) * x.slope / root};
  }
};

/// The value without derivatives of whatever the scalar carries.
inline double plain_value(double x) {
  return x;
}
inline double plain_value(long double x) {
  return static_cast<double>(x);
}
template <class R>
double plain_value(const std::complex<R>& x) {
  return static_cast<double>(x.real());
}
template <class T>
requires requires(const T& x) {
  x.value;
}
double plain_value(const T& x) {
  return plain_value(x.value);
}

/// An elastic law under plane stress: F_33 is such that P_33 = 0, to round-off. THEORY (4.10).
/// W(F) is then a minimum over F_33, so that P = dW/dF holds with F_33 held, and dP/dF is the condensed
/// tangent. Shears with the third direction are zero. Where there is no such F_33 > 0 the results are not a
/// number.
template <class M>
struct PlaneStress {
  static constexpr std::string_view name = M::name;
  M law;

  explicit PlaneStress(const M& in_3d) : law(in_3d) {}
  explicit PlaneStress(const Elastic& elastic) : law(elastic) {}

  template <class T>
  T energy(const Mat<2, T>& F) const {
    return law.energy(with_thickness(F, thickness(F)));
  }
  template <class T>
  Mat<2, T> first_piola(const Mat<2, T>& F) const {
    const Mat<3, T> P = law.first_piola(with_thickness(F, thickness(F)));
    Mat<2, T> in_plane;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) in_plane(a, b) = P(a, b);
    return in_plane;
  }

  /// F_33.
  template <class T>
  T thickness(const Mat<2, T>& F) const {
    if constexpr (std::same_as<T, double>) {
      return by_newton(F);
    } else if constexpr (requires { typename T::Lanes; }) {
      return of_lanes(F);
    } else {
      // Newton's steps with the slope at the solution: each doubles what derivatives T carries, or its
      // digits.
      Mat<2> plain;
      for (int n = 0; n < 4; ++n) plain(n / 2, n % 2) = plain_value(F(n / 2, n % 2));
      const double solution = by_newton(plain), slope = normal_stress(plain, solution).slope;
      T t(solution);
      for (int step = 0; step < 3; ++step) t = t - law.first_piola(with_thickness(F, t))(2, 2) * T(1 / slope);
      return t;
    }
  }

  /// F in three dimensions.
  template <class T>
  static Mat<3, T> with_thickness(const Mat<2, T>& F, const T& t) {
    Mat<3, T> G;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) G(a, b) = a < 2 && b < 2 ? F(a % 2, b % 2) : T(0);
    G(2, 2) = t;
    return G;
  }

 private:
  /// P_33 and its derivative by F_33 [Pa].
  template <class T>
  Sloped<T> normal_stress(const Mat<2, T>& F, const T& t) const {
    Mat<2, Sloped<T>> G;
    for (int n = 0; n < 4; ++n) G(n / 2, n % 2) = Sloped<T>(F(n / 2, n % 2), T(0));
    return law.first_piola(with_thickness(G, Sloped<T>(t, T(1))))(2, 2);
  }

  /// Newton's method kept in a bracket. P_33 is negative on the left of the solution and positive on its
  /// right.
  double by_newton(const Mat<2>& F) const {
    if (!(determinant<2, double>(F) > 0)) return std::numeric_limits<double>::quiet_NaN();
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    double low = 0, high = std::numeric_limits<double>::infinity(), t = 1;
    for (int n = 0; n < 100; ++n) {
      const Sloped<double> stress = normal_stress(F, t);
      if (stress.value == 0) return t;
      (stress.value < 0 ? low : high) = t;
      double next = t - stress.value / stress.slope;
      if (!(next > low && next < high)) next = high < 1e300 ? 0.5 * (low + high) : 2 * t;
      if (std::abs(next - t) <= 2 * rounding * t) return next;
      t = next;
    }
    // the last digit may go to and fro; a bracket that is still wide means that there is none
    const bool found = high < 1e300 && high - low <= 16 * rounding * high;
    return found ? t : std::numeric_limits<double>::quiet_NaN();
  }

  /// Newton's method on all lanes at once; lanes that it does not serve get theirs one by one.
  template <int W>
  Pack<W> of_lanes(const Mat<2, Pack<W>>& F) const {
    Pack<W> t(1), step(0);
    for (int n = 0; n < 8; ++n) {
      const Sloped<Pack<W>> stress = normal_stress(F, t);
      step = stress.value / stress.slope;
      t = t - step;
      if (all_small(step, t, 1e-9)) break;  // its square is below round-off: t has converged
    }
    double values[W];
    t.store(values);
    for (int lane = 0; lane < W; ++lane) {
      if (std::abs(step[lane]) <= 1e-9 * values[lane]) continue;
      Mat<2> alone;
      for (int k = 0; k < 4; ++k) alone(k / 2, k % 2) = F(k / 2, k % 2)[lane];
      values[lane] = by_newton(alone);
    }
    return Pack<W>::load(values);
  }
  template <int W>
  static bool all_small(const Pack<W>& step, const Pack<W>& t, double tolerance) {
    bool small = true;
    for (int lane = 0; lane < W; ++lane) small = small && std::abs(step[lane]) <= tolerance * t[lane];
    return small;
  }
};

}  // namespace plumb
