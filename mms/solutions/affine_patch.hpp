#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Patch test in motion: stretch and shear in turn with a superposed rotation about the z axis,
///   x = Q(r g) (I + g S) X,  g = sin(2 pi t/T),  S = stretch diag(1, -1/2, 1/3) + shear (e_x (x) e_y + ..).
/// F is uniform, so Div P = 0 and the body force is rho u_tt. A scheme that is exact for affine maps shows
/// round-off. In 1D there is the stretch alone: shear and rotation have no part in it.
struct AffinePatch {
  static constexpr std::string_view name = "affine-patch";
  static constexpr std::string_view summary =
      "uniform stretch, shear and rotation; F is uniform (patch test)";
  template <int d>
  static constexpr bool in_dimension = d >= 1 && d <= 3;
  static Parameters defaults() {
    return {{"stretch", 0.2, "1", 0, 0.5, "principal stretch less one"},
            {"shear", 0.15, "1", 0, 0.4, "shear strain"},
            {"rotation", 0.7, "rad", -3, 3, "largest angle of the superposed rotation"},
            {"period", 0.05, "s", 1e-3, 10, "period T"}};
  }
  static Elastic material() { return soft_rubber(); }

  double stretch, shear, rotation, period_;

  AffinePatch(const Parameters& p, const Elastic&)
      : stretch(p["stretch"]), shear(p["shear"]), rotation(p["rotation"]), period_(p["period"]) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T g = sin(T(2 * pi / period_) * t);
    Vec<d, T> y = X;  // (I + g S) X
    if constexpr (d == 1) {
      y[0] = T(stretch) * g * X[0];
      return y;
    } else {
      y[0] = X[0] + g * (T(stretch) * X[0] + T(shear) * X[1]);
      y[1] = X[1] - T(stretch / 2) * g * X[1];
      if constexpr (d == 3) y[2] = X[2] + g * (T(stretch / 3) * X[2] + T(shear / 2) * X[0]);
      const T angle = T(rotation) * g;
      const T c = cos(angle), s = sin(angle);
      Vec<d, T> u = y - X;
      u[0] = c * y[0] - s * y[1] - X[0];
      u[1] = s * y[0] + c * y[1] - X[1];
      return u;
    }
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), held);
  }
  double period() const { return period_; }
};

}  // namespace plumb::mms
