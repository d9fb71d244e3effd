#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Bar of 1 m in uniaxial strain, held at x- and loaded at x+ by a traction that swings:
///   u_x = A sin(k X) sin(k c t),  c = sqrt((lambda + 2 mu)/rho).
/// Solves linear elasticity with the traction (lambda + 2 mu) A k cos(k 1 m) sin(k c t) on x+. The sides are
/// rollers. No multiple of pi/2 as k gives an end that is neither free nor held.
struct LoadedBar {
  static constexpr std::string_view name = "loaded-bar";
  static constexpr std::string_view summary = "longitudinal wave in a bar that a traction drives at its end";
  template <int d>
  static constexpr bool in_dimension = d == 2 || d == 3;
  static Parameters defaults() {
    return {{"amplitude", 0.01, "m", 0, 0.05, "amplitude A"},
            {"wave_number", 2, "1/m", 0.5, 8, "wave number k"}};
  }
  static Elastic material() { return soft_rubber(); }

  double amplitude, k, speed;

  LoadedBar(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), k(p["wave_number"]), speed(e.wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::sin;
    Vec<d, T> u = T(0) * X;
    u[0] = T(amplitude) * sin(T(k) * X[0]) * sin(T(k * speed) * t);
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    Domain<d> domain = box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), roller);
    domain.faces[1] = loaded;
    return domain;
  }
  double period() const { return 2 * pi / (k * speed); }
};

}  // namespace plumb::mms
