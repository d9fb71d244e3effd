#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Swinging plate, paper 000 (42), (43), on [0, 2]^2 m:
///   u = U sin(omega t) (-sin(pi X/2) cos(pi Y/2), cos(pi X/2) sin(pi Y/2)),  omega = pi/2 sqrt(2 mu/rho).
/// It is divergence-free at small strain and solves LINEAR elasticity without a body force. With a
/// finite-strain material it needs one, of relative size U. The edges are rollers: u.N = 0, and F is diagonal
/// there, so that no isotropic material has a tangential traction.
struct SwingingPlate {
  static constexpr std::string_view name = "swinging-plate";
  static constexpr std::string_view summary =
      "square plate on rollers in its first shear mode (paper 000, 5.1)";
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() {
    return {{"amplitude", 0.01, "m", 0, 0.3, "amplitude U of the displacement"}};
  }
  static Elastic material() { return {17e6, 0.495, 1100}; }

  double amplitude, omega;

  SwingingPlate(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), omega(pi / 2 * std::sqrt(2 * e.shear_modulus() / e.density)) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T swing = T(amplitude) * sin(T(omega) * t);
    const T a = T(pi / 2) * X[0], b = T(pi / 2) * X[1];
    Vec<d, T> u;
    u[0] = -(swing * sin(a) * cos(b));
    u[1] = swing * cos(a) * sin(b);
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Constant(2), roller);
  }
  double period() const { return 2 * pi / omega; }
};

}  // namespace plumb::mms
