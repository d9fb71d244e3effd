#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Cantilever 0 < X < L = 8 m, |Y| < D/2 = 1.5 m that a parabola of shear bends at x+ (S. P. Timoshenko and
/// J. N. Goodier, Theory of Elasticity, 3rd ed. 1970, section 21), with E, nu of plane stress, or E/(1 - nu^2)
/// and nu/(1 - nu) of plane strain in their place, I = D^3/12 and the force P upwards:
///   u_x = -P Y/(6 E I) ((6 L - 3 X) X + (2 + nu) (Y^2 - D^2/4)),
///   u_y = P/(6 E I) (3 nu Y^2 (L - X) + (4 + 5 nu) D^2 X/4 + (3 L - X) X^2).
/// At rest; solves linear elasticity without a body force; y- and y+ are free, and x- is held where the field
/// has it.
struct PlaneCantilever {
  static constexpr std::string_view name = "plane-cantilever";
  static constexpr std::string_view summary = "cantilever bent by a parabola of shear at its end, at rest";
  static constexpr bool still = true;
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() {
    return {{"load", 1e-4, "1", 0, 0.01, "mean shear stress P/D of the end over the shear modulus"}};
  }
  static Elastic material() { return soft_rubber(); }

  static constexpr double length = 8, depth = 3;
  double nu, scale, time;

  PlaneCantilever(const Parameters& p, const Elastic& e)
      : nu(e.lame() / (e.lame() + 2 * e.shear_modulus())),
        scale(p["load"] / (2 * (1 + nu)) * 2 / (depth * depth)),  // P/(6 E I), E = 2 (1 + nu) mu
        time(length / e.shear_wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T&) const {
    const T x = X[0], y = X[1];
    constexpr double quarter = depth * depth / 4;
    Vec<d, T> u;
    u[0] = -(T(scale) * y * ((T(6 * length) - T(3) * x) * x + T(2 + nu) * (y * y - T(quarter))));
    u[1] = T(scale) * (T(3 * nu) * y * y * (T(length) - x) + T((4 + 5 * nu) * quarter) * x +
                       (T(3 * length) - x) * x * x);
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    Domain<d> domain = box_domain<d>(Vec<d>(0, -depth / 2), Vec<d>(length, depth), loaded);
    domain.faces[0] = held;
    return domain;
  }
  double period() const { return time; }
};

}  // namespace plumb::mms
