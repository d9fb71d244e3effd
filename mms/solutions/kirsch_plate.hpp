#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Plate with a round hole, pulled along x (G. Kirsch, Z. VDI 42, 797, 1898): the ring 1 m < R < 2 m of it,
/// with a free hole. With x, y in radii of the hole, q = 1/(x^2 + y^2), kappa = (lambda + 3 mu)/(lambda + mu)
/// and the tension S far away:
///   u_x = S/(8 mu) ((kappa + 1) x + 2 (kappa - 2) x q + 8 x^3 q^2 + 6 x q^2 - 8 x^3 q^3),
///   u_y = S/(8 mu) ((kappa - 3) y + 2 (4 - kappa) y q - 8 y^3 q^2 - 6 y q^2 + 8 y^3 q^3),
/// times 1 m. At rest; solves linear elasticity without a body force. The stress at the hole reaches 3 S.
struct KirschPlate {
  static constexpr std::string_view name = "kirsch-plate";
  static constexpr std::string_view summary = "plate with a free round hole under tension, at rest";
  static constexpr bool still = true;
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() {
    return {{"tension", 1e-3, "1", 0, 0.1, "tension S far away over the shear modulus"}};
  }
  static Elastic material() { return soft_rubber(); }

  double scale, kappa, time;

  KirschPlate(const Parameters& p, const Elastic& e)
      : scale(p["tension"] / 8),
        kappa((e.lame() + 3 * e.shear_modulus()) / (e.lame() + e.shear_modulus())),
        time(1 / e.shear_wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T&) const {
    const T x = X[0], y = X[1];
    const T q = T(1) / (x * x + y * y);
    Vec<d, T> u;
    u[0] = T(scale) * x * (T(kappa + 1) + q * (T(2 * (kappa - 2)) + q * (T(6) + T(8) * x * x * (T(1) - q))));
    u[1] = T(scale) * y * (T(kappa - 3) + q * (T(2 * (4 - kappa)) - q * (T(6) + T(8) * y * y * (T(1) - q))));
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    Domain<d> domain = annulus_domain(1, 2, held);
    domain.faces[0] = loaded;
    return domain;
  }
  double period() const { return time; }
};

}  // namespace plumb::mms
