#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Standing longitudinal wave in the unit box on rollers: u_x = A sin(n pi X) cos(n pi c t), c = sqrt((lambda
/// + 2 mu)/rho). An eigenmode of the linear box; with a finite-strain material the body force makes it exact.
/// In 1D the box is a bar whose ends are held.
struct StandingWave {
  static constexpr std::string_view name = "standing-wave";
  static constexpr std::string_view summary = "longitudinal eigenmode of a box on rollers";
  template <int d>
  static constexpr bool in_dimension = d >= 1 && d <= 3;
  static Parameters defaults() {
    return {{"amplitude", 0.01, "m", 0, 0.05, "amplitude A"},
            {"mode", 1, "1", 1, 3, "number n of half waves"}};
  }
  static Elastic material() { return soft_rubber(); }

  double amplitude, k, speed;

  StandingWave(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), k(pi * p["mode"]), speed(e.wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    Vec<d, T> u = T(0) * X;
    u[0] = T(amplitude) * sin(T(k) * X[0]) * cos(T(k * speed) * t);
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), roller);
  }
  double period() const { return 2 * pi / (k * speed); }
};

}  // namespace plumb::mms
