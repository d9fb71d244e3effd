#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Trigonometric field on the unit cube, all components and derivatives at work:
///   u_i = A sin(omega t) a_i sin(pi X_i) cos(pi X_j) cos(pi X_k),  a = (1, -0.6, -0.4),  omega = pi sqrt(3
///   mu/rho).
/// The a_i add up to zero, so the volume change is of second order. On the faces u.N = 0 and F is diagonal:
/// rollers.
struct TrigonometricCube {
  static constexpr std::string_view name = "trigonometric-cube";
  static constexpr std::string_view summary = "cube on rollers in a three-dimensional shear mode";
  template <int d>
  static constexpr bool in_dimension = d == 3;
  static Parameters defaults() { return {{"amplitude", 0.05, "m", 0, 0.2, "amplitude A of u_x"}}; }
  static Elastic material() { return soft_rubber(); }

  double amplitude, omega;

  TrigonometricCube(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), omega(pi * std::sqrt(3 * e.shear_modulus() / e.density)) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T swing = T(amplitude) * sin(T(omega) * t);
    T s[3], c[3];
    for (int i = 0; i < 3; ++i) {
      s[i] = sin(T(pi) * X[i]);
      c[i] = cos(T(pi) * X[i]);
    }
    Vec<d, T> u;
    u[0] = swing * s[0] * c[1] * c[2];
    u[1] = T(-0.6) * swing * c[0] * s[1] * c[2];
    u[2] = T(-0.4) * swing * c[0] * c[1] * s[2];
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), roller);
  }
  double period() const { return 2 * pi / omega; }
};

}  // namespace plumb::mms
