#pragma once
#include "lib/core/roots.hpp"
#include "lib/particles/block.hpp"
#include "lib/schemes/gather.hpp"
#include "lib/schemes/mixed/mixed_bonds.hpp"
#include "lib/schemes/tensors.hpp"

/// Dissipation between pairs: (59), (60) of paper 003. What the pairs differ in is the jump of the velocity
/// that they see; each has a file of its own (upwind_constant.hpp, upwind_reconstructed.hpp,
/// upwind_adjoint.hpp).
namespace plumb {

/// What a jump may read.
template <int d>
struct UpwindSite {
  const MixedBonds<d>& bonds;
  const Field& u;         ///< displacement [m]
  const Field& v;         ///< velocity [m/s]
  const Field& F;         ///< deformation gradient
  const Field& gradient;  ///< of the velocity [1/s]: spatial for the adjoint jump, else for the reference
  const Field& stretch;   ///< least principal stretch
  const Field& chi;       ///< displacement of the reference [m]; no components while it is X
  double pressure_speed;  ///< c_p of the undeformed body [m/s]
  double shear_speed;     ///< c_s likewise
};

/// Forces of the pairs on one block, per reference volume [N/m^d], and what they dissipate [W/m^d]. With
/// S = rho |C^Skew|/2 [c_p n (x) n + c_s (I - n (x) n)], n along x_ab and speeds over the mean least stretch
/// of the pair (63): q = S w. A jump that says `adjoint` also gives the stress P what the velocity gradients
/// in it do to the force, THEORY (16.3).
template <int d, int W, class Jump>
void upwind_sweep(const UpwindSite<d>& site, const Block& block, Field& force, Field& power, Field& P) {
  using Real = Pack<W>;
  using Vector = Vec<d, Real>;
  const BondTable<d>& t = site.bonds.table;
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
      const Real inverse = bond_number<W>(site.bonds.impedance, n) / (square * both);
      const Real across = inverse * square * shear, along = inverse * rest * dot<d, Real>(x, w);
      Vector q;
      for (int k = 0; k < d; ++k) {
        q[k] = across * w[k] + along * x[k];
        f[k] += q[k];
      }
      loss += dot<d, Real>(q, Jump::adjoint ? w : dv);
      if constexpr (Jump::adjoint) add_outer<d, Real>(Q, q, x);
    });
    store_vector<d, W>(f, force, i);
    (Real(0.5) * loss).store(power[0] + i);
    if constexpr (Jump::adjoint) {
      const Mat<d, Real> push = inverse_transpose<d, Real>(load_tensor<d, W>(site.F, i));
      Mat<d, Real> stress = load_tensor<d, W>(P, i);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b)
          for (int c = 0; c < d; ++c) stress(a, b) -= Real(0.5) * Q(a, c) * push(c, b);
      store_tensor<d, W>(stress, P, i);
    }
  }
}

}  // namespace plumb
