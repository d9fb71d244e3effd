#pragma once
#include "mms/solution.hpp"

namespace plumb::mms {

/// Column of height 2 m and width 1 m, pulled along its last axis with tractions on all faces but the held
/// base:
///   z = Z + e g (Z + 0.2 sin(pi Z/2)),  x = X (1 - c g sin(pi Z/4)),  g = (1 - cos(2 pi t/T))/2,
/// so that it starts at rest, the stretch 1 + e reaches 2 and more, and all of F varies along the column. In 1D it is
/// a bar with a loaded end: the contraction has no part in it.
struct StretchedColumn {
  static constexpr std::string_view name = "stretched-column";
  static constexpr std::string_view summary = "column pulled to large stretch by prescribed tractions";
  template <int d>
  static constexpr bool in_dimension = d >= 1 && d <= 3;
  static Parameters defaults() {
    return {{"stretch", 1, "1", 0, 1.5, "mean extension e"},
            {"contraction", 0.25, "1", 0, 0.4, "contraction c of the top"},
            {"period", 0.2, "s", 1e-3, 10, "period T of pulling and letting go"}};
  }
  static Elastic material() { return soft_rubber(); }

  double stretch, contraction, period_;

  StretchedColumn(const Parameters& p, const Elastic&)
      : stretch(p["stretch"]), contraction(p["contraction"]), period_(p["period"]) {}

  template <int d, class T>
  Vec<d, T> displacement(const Vec<d, T>& X, const T& t) const {
    using std::cos, std::sin;
    const T g = T(0.5) * (T(1) - cos(T(2 * pi / period_) * t));
    const T Z = X[d - 1];
    const T thinner = T(contraction) * g * sin(T(pi / 4) * Z);
    Vec<d, T> u;
    for (int i = 0; i < d - 1; ++i) u[i] = -(thinner * X[i]);
    u[d - 1] = T(stretch) * g * (Z + T(0.2) * sin(T(pi / 2) * Z));
    return u;
  }

  template <int d>
  Domain<d> domain() const {
    Vec<d> origin = Vec<d>::Constant(-0.5), size = Vec<d>::Ones();
    origin[d - 1] = 0;
    size[d - 1] = 2;
    Domain<d> domain = box_domain<d>(origin, size, loaded);
    domain.faces[2 * (d - 1)] = held;
    return domain;
  }
  double period() const { return period_; }
};

}  // namespace plumb::mms
