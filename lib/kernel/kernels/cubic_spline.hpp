#pragma once
#include <numbers>
#include <string_view>

namespace plumb {

/// Cubic B-spline, support 2h: s (1 - 3/2 q^2 + 3/4 q^3) for q < 1, s (2 - q)^3 / 4 for q < 2;
/// s = 2/3, 10/(7 pi), 1/pi in 1D, 2D, 3D. THEORY (1.2).
struct CubicSpline {
  static constexpr std::string_view name = "cubic";
  static constexpr double support = 2;

  template <int d>
  static constexpr double scale = d == 1   ? 2.0 / 3
                                  : d == 2 ? 10 / (7 * std::numbers::pi)
                                           : 1 / std::numbers::pi;

  template <int d>
  static double w(double q) {
    if (q >= 2) return 0;
    const double t = 2 - q;
    return scale<d> * (q < 1 ? 1 - q * q * (1.5 - 0.75 * q) : 0.25 * t * t * t);
  }
  template <int d>
  static double dw(double q) {
    if (q >= 2) return 0;
    const double t = 2 - q;
    return scale<d> * (q < 1 ? q * (2.25 * q - 3) : -0.75 * t * t);
  }
};

}  // namespace plumb
