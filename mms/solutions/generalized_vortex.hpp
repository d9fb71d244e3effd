#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Generalized vortex (Kamojjala, Brannon, Sadeghirad, Guilkey 2015) on the annulus 0.75 < R < 1.25 m:
/// every ring turns by alpha(R, t) = A/2 (1 - cos(2 pi t/T)) (1 - 32 (R-1)^2 + 256 (R-1)^4).
/// Very large shear, no change of volume. alpha and its slope vanish on both circles: F = I and no traction
/// there.
struct GeneralizedVortex {
  static constexpr std::string_view name = "generalized-vortex";
  static constexpr std::string_view summary =
      "rings of an annulus turned against each other; free circles, large shear";
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() {
    return {{"amplitude", 1, "rad", 0, 2, "largest angle A"}, {"period", 1, "s", 0.1, 10, "period T"}};
  }
  static Elastic material() { return {1000, 0.3, 1000}; }

  double amplitude, period_;

  GeneralizedVortex(const Parameters& p, const Elastic&) : amplitude(p["amplitude"]), period_(p["period"]) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin, std::sqrt;
    const T radius = sqrt(X[0] * X[0] + X[1] * X[1]);
    const T q = (radius - T(1)) * (radius - T(1));
    const T shape = T(1) - T(32) * q + T(256) * q * q;
    const T angle = T(amplitude / 2) * (T(1) - cos(T(2 * pi / period_) * t)) * shape;
    const T c = cos(angle), s = sin(angle);
    Vec<d, T> u;
    u[0] = c * X[0] - s * X[1] - X[0];
    u[1] = s * X[0] + c * X[1] - X[1];
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    return annulus_domain(0.75, 1.25, loaded);
  }
  double period() const { return period_; }
};

}  // namespace plumb::mms
