#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Lamé's mode of a free square, [0, 1]^2 m (K. F. Graff, Wave Motion in Elastic Solids, 1975, 7.6):
///   u = A sin(omega t) (cos(pi X) sin(pi Y), -sin(pi X) cos(pi Y)),  omega = pi sqrt(2 mu/rho).
/// Neither volume nor the angle between the edges changes, so that linear elasticity needs no body force and
/// leaves every edge free of traction, for every Poisson's ratio. A finite-strain material needs both, of
/// relative size A.
struct LameMode {
  static constexpr std::string_view name = "lame-mode";
  static constexpr std::string_view summary = "free square in a shear mode of its own, all edges free";
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() { return {{"amplitude", 0.01, "m", 0, 0.1, "amplitude A"}}; }
  static Elastic material() { return soft_rubber(); }

  double amplitude, omega;

  LameMode(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), omega(pi * std::sqrt(2 * e.shear_modulus() / e.density)) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T swing = T(amplitude) * sin(T(omega) * t);
    const T a = T(pi) * X[0], b = T(pi) * X[1];
    Vec<d, T> u;
    u[0] = swing * cos(a) * sin(b);
    u[1] = -(swing * sin(a) * cos(b));
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), loaded);
  }
  double period() const { return 2 * pi / omega; }
};

}  // namespace plumb::mms
