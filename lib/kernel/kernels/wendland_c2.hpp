#pragma once
#include <numbers>
#include <string_view>

namespace plumb {

/// Wendland C2, support 2h. 2D and 3D: s (1 - q/2)^4 (2q + 1), s = 7/(4 pi), 21/(16 pi). In 1D the function
/// that is positive definite has its own polynomial: 5/8 (1 - q/2)^3 (3q/2 + 1). THEORY (1.4).
struct WendlandC2 {
  static constexpr std::string_view name = "wendland-c2";
  static constexpr double support = 2;

  template <int d>
  static double w(double q) {
    if (q >= 2) return 0;
    const double t = 1 - 0.5 * q;
    if constexpr (d == 1)
      return 0.625 * t * t * t * (1.5 * q + 1);
    else
      return scale<d> * t * t * t * t * (2 * q + 1);
  }
  template <int d>
  static double dw(double q) {
    if (q >= 2) return 0;
    const double t = 1 - 0.5 * q;
    if constexpr (d == 1)
      return -1.875 * q * t * t;
    else
      return -5 * scale<d> * q * t * t * t;
  }

 private:
  template <int d>
  static constexpr double scale = d == 2 ? 7 / (4 * std::numbers::pi) : 21 / (16 * std::numbers::pi);
};

}  // namespace plumb
