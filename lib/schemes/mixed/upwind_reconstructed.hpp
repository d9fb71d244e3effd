#pragma once
#include "lib/schemes/upwind.hpp"

namespace plumb {

/// Linear reconstruction, as paper 003 has it: v_b - v_a - (G_a + G_b) chi_ab/2 with the gradient G of the
/// velocity in the reference. Zero for fields that are linear there. Not dissipative pair by pair, nor in sum
/// for every field.
template <int d, int W>
struct ReconstructedJump {
  static constexpr bool adjoint = false;
  using Real = Pack<W>;

  ReconstructedJump(const UpwindSite<d>& where, Index i)
      : site(where), gradient(load_tensor<d, W>(where.gradient, i)), moved(where.chi.components() > 0) {
    if (moved) chi = load_vector<d, W>(where.chi, i);
  }
  Vec<d, Real> operator()(std::int64_t n, Index j, const Vec<d, Real>& dv, const Vec<d, Real>&) const {
    Vec<d, Real> arm = bond_vector<d, W>(site.table.separation, n), w = dv;
    for (int k = 0; k < d && moved; ++k) arm[k] += Real::load(site.chi[k] + j) - chi[k];
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        w[a] -= Real(0.5) * (gradient(a, b) + Real::load(site.gradient[a * d + b] + j)) * arm[b];
    return w;
  }

  const UpwindSite<d>& site;
  Mat<d, Real> gradient;
  Vec<d, Real> chi = zero_vector<d, Real>();
  bool moved;
};

}  // namespace plumb
