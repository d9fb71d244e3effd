#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Rigid rotation about the z axis through the middle of the unit box, angle = omega t: P = 0 by objectivity,
/// and the body force is the centripetal one alone. Shows whether F is a rotation to round-off, and the error
/// of time integration.
struct RigidRotation {
  static constexpr std::string_view name = "rigid-rotation";
  static constexpr std::string_view summary = "rotation at a constant rate; no stress (objectivity)";
  template <int d>
  static constexpr bool in_dimension = d == 2 || d == 3;
  static Parameters defaults() { return {{"spin", 105, "rad/s", -1000, 1000, "angular velocity"}}; }
  static Elastic material() { return soft_rubber(); }

  double spin;

  RigidRotation(const Parameters& p, const Elastic&) : spin(p["spin"]) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T c = cos(T(spin) * t), s = sin(T(spin) * t);
    const T x = X[0] - T(0.5), y = X[1] - T(0.5);
    Vec<d, T> u = T(0) * X;
    u[0] = c * x - s * y - x;
    u[1] = s * x + c * y - y;
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), loaded);
  }
  double period() const { return 2 * pi / std::max(1.0, std::abs(spin)); }
};

}  // namespace plumb::mms
