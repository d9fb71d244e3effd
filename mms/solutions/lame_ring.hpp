#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Thick ring 1 m < R < 2 m under a pressure p from inside, free outside (G. Lamé, Leçons sur la théorie
/// mathématique de l'élasticité, 1852):
///   u = p a^2/(b^2 - a^2) (1/(2 (lambda + mu)) + b^2/(2 mu R^2)) X.
/// At rest; solves linear elasticity without a body force. The outer circle is held where the field has it,
/// which keeps the ring from moving as a whole.
struct LameRing {
  static constexpr std::string_view name = "lame-ring";
  static constexpr std::string_view summary = "thick ring under pressure from inside, at rest";
  static constexpr bool still = true;
  template <int d>
  static constexpr bool in_dimension = d == 2;
  static Parameters defaults() {
    return {{"pressure", 1e-3, "1", 0, 0.1, "pressure p over the shear modulus"}};
  }
  static Elastic material() { return soft_rubber(); }

  double scale, ratio, time;

  LameRing(const Parameters& p, const Elastic& e)
      : scale(p["pressure"] / 6),  // p/mu a^2/(2 (b^2 - a^2))
        ratio(e.shear_modulus() / (e.lame() + e.shear_modulus())),
        time(1 / e.shear_wave_speed()) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T&) const {
    const T factor = T(scale) * (T(ratio) + T(4) / (X[0] * X[0] + X[1] * X[1]));
    Vec<d, T> u;
    u[0] = factor * X[0];
    u[1] = factor * X[1];
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
