#pragma once
#include <numbers>
#include <string_view>

namespace plumb {

/// Quintic B-spline, support 3h: s ((3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5), each power only where its base is
/// positive; s = 1/120, 7/(478 pi), 1/(120 pi) in 1D, 2D, 3D. THEORY (1.3).
struct QuinticSpline {
  static constexpr std::string_view name = "quintic";
  static constexpr double support = 3;

  template <int d>
  static constexpr double scale = d == 1   ? 1.0 / 120
                                  : d == 2 ? 7 / (478 * std::numbers::pi)
                                           : 1 / (120 * std::numbers::pi);

  template <int d>
  static double w(double q) {
    return scale<d> * (power5(3 - q) - 6 * power5(2 - q) + 15 * power5(1 - q));
  }
  template <int d>
  static double dw(double q) {
    return -5 * scale<d> * (power4(3 - q) - 6 * power4(2 - q) + 15 * power4(1 - q));
  }

 private:
  static double power4(double t) { return t > 0 ? t * t * t * t : 0; }
  static double power5(double t) { return t > 0 ? t * t * t * t * t : 0; }
};

}  // namespace plumb
