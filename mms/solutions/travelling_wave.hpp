#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Travelling longitudinal wave u_x = A sin(k (X - c t)), k = n pi, c = sqrt((lambda + 2 mu)/rho), through
/// the unit box: the normal displacement is prescribed on all faces and moves on x- and x+; the sides carry
/// no shear.
struct TravellingWave {
  static constexpr std::string_view name = "travelling-wave";
  static constexpr std::string_view summary = "longitudinal wave through a box, ends moved with it";
  template <int d>
  static constexpr bool in_dimension = d >= 1 && d <= 3;
  static Parameters defaults() {
    return {{"amplitude", 0.01, "m", 0, 0.05, "amplitude A"},
            {"mode", 2, "1", 1, 3, "number n of half waves in the box"}};
  }
  static Elastic material() { return soft_rubber(); }

  double amplitude, k, speed;

  TravellingWave(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), k(pi * p["mode"]), speed(e.wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::sin;
    Vec<d, T> u = T(0) * X;
    u[0] = T(amplitude) * sin(T(k) * (X[0] - T(speed) * t));
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), roller);
  }
  double period() const { return 2 * pi / (k * speed); }
};

}  // namespace plumb::mms
