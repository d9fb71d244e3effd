#pragma once
#include <algorithm>
#include <cmath>

#include "lib/core/roots.hpp"
#include "lib/material/material.hpp"
#include "lib/particles/block.hpp"
#include "lib/schemes/gather.hpp"
#include "lib/schemes/tensors.hpp"

/// Dissipation between pairs: (59), (60) of paper 003. What the pairs differ in is the jump of the velocity
/// that they see; each has a file of its own (upwind_adjoint.hpp, and those of schemes/mixed).
namespace plumb {

/// What a jump may read.
template <int d>
struct UpwindSite {
  const BondTable<d>& table;
  const AlignedVector& impedance;  ///< per bond, width: pair_impedance() [kg/m^(d+1)]
  const Field& u;                  ///< displacement [m]
  const Field& v;                  ///< velocity [m/s]
  const Field& gradient;  ///< of the velocity [1/s]: spatial for the adjoint jump, else for the reference
  const Field& stretch;   ///< least principal stretch
  const Field& chi;       ///< displacement of the reference [m]; no components while it is X
  double pressure_speed;  ///< c_p of the undeformed body [m/s]
  double shear_speed;     ///< c_s likewise
};

/// Largest c_p/c_s that the adjoint upwinding follows; beyond, nearly incompressible bodies lose their energy
/// to it (nu = 0.495 has 10: a column in tension loses 71 % of its energy).
inline constexpr double most_speed_ratio = 5;

/// The speed [m/s] of pressure waves that the adjoint upwinding takes.
inline double followed_pressure_speed(const Elastic& elastic) {
  return std::min(elastic.wave_speed(), most_speed_ratio * elastic.shear_wave_speed());
}

/// Makes rho |C^Skew|/(2 V_a) of (60) from the constants of a table, whose force is the adjoint one: per bond, width
/// [kg/m^(d+1)].
template <int d>
AlignedVector pair_impedance(const BondTable<d>& t, double density) {
  AlignedVector impedance(t.offset.size() * static_cast<std::size_t>(t.width), 0.0);
  for (std::size_t n = 0; n < t.offset.size(); ++n)
    for (int lane = 0; lane < t.width; ++lane) {
      double square = 0;
      for (int k = 0; k < d; ++k) {
        const std::size_t place = (n * d + k) * t.width + lane;
        const double skew = t.stencil[place] + t.force_weights()[place];
        square += skew * skew;
      }
      impedance[n * t.width + lane] = 0.5 * density * std::sqrt(square);
    }
  return impedance;
}

/// stress -= Q F^-T/2 with Q = sum q (x) x_ab: what the velocity gradients in an adjoint jump do to the force, THEORY (16.3).
template <int d, class Real>
void carry_by_stress(const Mat<d, Real>& Q, const Mat<d, Real>& push, Mat<d, Real>& stress) {
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b)
      for (int c = 0; c < d; ++c) stress(a, b) -= Real(0.5) * Q(a, c) * push(c, b);
}

/// Calls take(i, f, power, Q) for every pack of a block: the forces of its pairs per reference volume [N/m^d], what they
/// dissipate [W/m^d], and the sum q (x) x_ab of a jump that says `adjoint` (otherwise zero). With
/// S = rho |C^Skew|/2 [c_p n (x) n + c_s (I - n (x) n)], n along x_ab and speeds over the mean least stretch
/// of the pair (63): q = S w.
template <int d, int W, class Jump, class Take>
void upwind_sweep(const UpwindSite<d>& site, const Block& block, Take&& take) {
  using Real = Pack<W>;
  using Vector = Vec<d, Real>;
  const BondTable<d>& t = site.table;
  const Real shear(2 * site.shear_speed), rest(2 * (site.pressure_speed - site.shear_speed));
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    const Vector u = load_vector<d, W>(site.u, i), v = load_vector<d, W>(site.v, i);
    const Real stretch = Real::load(site.stretch[0] + i);
    const Jump jump(site, i);
    Vector f = zero_vector<d, Real>();
    Mat<d, Real> Q = zero_tensor<d, Real>();
    Real loss(0);
    for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
      Vector x, dv;
      for (int k = 0; k < d; ++k) {
        x[k] = Real::load(t.separation.data() + (n * d + k) * W) + (Real::load(site.u[k] + j) - u[k]);
        dv[k] = Real::load(site.v[k] + j) - v[k];
      }
      const Vector w = jump(n, j, dv, x);
      const Real square = dot<d, Real>(x, x) + Real(1e-200);  // a lane without this neighbour may have x = 0
      const Real both = stretch + Real::load(site.stretch[0] + j);
      const Real inverse = bond_number<W>(site.impedance, n) / (square * both);
      const Real across = inverse * square * shear, along = inverse * rest * dot<d, Real>(x, w);
      Vector q;
      for (int k = 0; k < d; ++k) {
        q[k] = across * w[k] + along * x[k];
        f[k] += q[k];
      }
      loss += dot<d, Real>(q, Jump::adjoint ? w : dv);
      if constexpr (Jump::adjoint) add_outer<d, Real>(Q, q, x);
    });
    take(i, f, Real(0.5) * loss, Q);
  }
}

}  // namespace plumb
