#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Churchill's bar (R. V. Churchill, Operational Mathematics, 3rd ed. 1972, section 43): 1 m in uniaxial
/// strain, held at x-, its end x+ under a constant traction from t = 0 on. The first N terms of the series
///   u_x = A (X - 8/pi^2 sum_n (-1)^(n-1)/(2n-1)^2 sin((2n-1) pi X/2) cos((2n-1) pi c t/2)),
/// with c = sqrt((lambda + 2 mu)/rho) and the traction (lambda + 2 mu) A/(1 m). Each term alone is free at x+
/// and solves linear elasticity, so that so do their sums. The whole series starts at rest with u = 0; its
/// kinks at the front of the wave are left out here. The sides are rollers.
struct ChurchillBar {
  static constexpr std::string_view name = "churchill-bar";
  static constexpr std::string_view summary =
      "bar under a constant traction at its end, by its first harmonics";
  template <int d>
  static constexpr bool in_dimension = d == 2 || d == 3;
  static Parameters defaults() {
    return {{"amplitude", 0.01, "m", 0, 0.05, "displacement A of the end at rest under the load"},
            {"harmonics", 3, "1", 1, 4, "number N of terms, rounded down"}};
  }
  static Elastic material() { return soft_rubber(); }

  double amplitude, speed;
  int harmonics;

  ChurchillBar(const Parameters& p, const Elastic& e)
      : amplitude(p["amplitude"]), speed(e.wave_speed()), harmonics(static_cast<int>(p["harmonics"])) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    T sum = X[0];
    double sign = -1;
    for (int n = 1; n <= harmonics; ++n, sign = -sign) {
      const double odd = 2 * n - 1, k = odd * pi / 2;
      sum = sum + T(sign * 8 / (pi * pi * odd * odd)) * sin(T(k) * X[0]) * cos(T(k * speed) * t);
    }
    Vec<d, T> u = T(0) * X;
    u[0] = T(amplitude) * sum;
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    Domain<d> domain = box_domain<d>(Vec<d>::Zero(), Vec<d>::Ones(), roller);
    domain.faces[1] = loaded;
    return domain;
  }
  double period() const { return 4 / speed; }
};

}  // namespace plumb::mms
