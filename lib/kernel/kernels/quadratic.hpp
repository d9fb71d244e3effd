#pragma once
#include <numbers>
#include <string_view>

namespace plumb {

/// Quadratic kernel, support 2h: s (1 - q/2)^2 (paper 003), s = 3/4, 3/(2 pi), 15/(16 pi) in 1D, 2D, 3D.
/// Its slope at q = 0 is not zero: W has a cusp, and the gradient at r = 0 is taken as zero. THEORY (1.5).
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr double support = 2;
  static constexpr bool cusp = true;  ///< dw(0) != 0

  template <int d>
  static constexpr double scale = d == 1   ? 0.75
                                  : d == 2 ? 3 / (2 * std::numbers::pi)
                                           : 15 / (16 * std::numbers::pi);

  template <int d>
  static double w(double q) {
    const double t = q < 2 ? 1 - 0.5 * q : 0;
    return scale<d> * t * t;
  }
  template <int d>
  static double dw(double q) {
    return q < 2 ? -scale<d> * (1 - 0.5 * q) : 0;
  }
};

}  // namespace plumb
