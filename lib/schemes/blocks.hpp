#pragma once
#include <algorithm>

#include "lib/particles/block.hpp"
#include "lib/schemes/gather.hpp"
#include "lib/schemes/tensors.hpp"

/// Loops over all slots of a table, block by block.
namespace plumb {

/// Returns how many blocks hold all slots of the table.
template <int d>
Index block_count(const BondTable<d>& t) {
  return (t.slots.count() + block_slots - 1) / block_slots;
}

/// Calls use(block) for every block, side by side; what a call writes must be its block's own.
template <int d, class Use>
void for_blocks(const BondTable<d>& t, Use&& use) {
  const Index blocks = block_count(t), per_block = block_slots / t.width;
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
  for (Index b = 0; b < blocks; ++b)
    use(Block{b * per_block, std::min((b + 1) * per_block, t.slots.packs()), t.width});
}

/// F = sum x_ab (x) c_ab of one pack, THEORY (16.1).
template <int d, int W>
inline Mat<d, Pack<W>> gradient_of_positions(const BondTable<d>& t, const Field& u, Index pack) {
  using Real = Pack<W>;
  const Vec<d, Real> own = load_vector<d, W>(u, pack * W);
  Mat<d, Real> F;
  for (int n = 0; n < d * d; ++n)
    F(n / d, n % d) = Real::load(t.identity.data() + (t.row[pack] * Index{d * d} + n) * W);
  for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
    Vec<d, Real> du;
    for (int k = 0; k < d; ++k) du[k] = Real::load(u[k] + j) - own[k];
    add_outer<d, Real>(F, du, bond_vector<d, W>(t.stencil, n));
  });
  return F;
}

/// F and the velocity gradient sum v_ab (x) c_ab of one pack, with one reading of the constants.
template <int d, int W>
inline void both_gradients(const BondTable<d>& t, const Field& u, const Field& v, Index pack,
                           Mat<d, Pack<W>>& F, Mat<d, Pack<W>>& G) {
  using Real = Pack<W>;
  const Index i = pack * W;
  const Vec<d, Real> own_u = load_vector<d, W>(u, i), own_v = load_vector<d, W>(v, i);
  for (int n = 0; n < d * d; ++n) {
    F(n / d, n % d) = Real::load(t.identity.data() + (t.row[pack] * Index{d * d} + n) * W);
    G(n / d, n % d) = Real(0);
  }
  for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
    const Vec<d, Real> c = bond_vector<d, W>(t.stencil, n);
    for (int a = 0; a < d; ++a) {
      const Real du = Real::load(u[a] + j) - own_u[a], dv = Real::load(v[a] + j) - own_v[a];
      for (int b = 0; b < d; ++b) {
        F(a, b) += du * c[b];
        G(a, b) += dv * c[b];
      }
    }
  });
}

/// The velocity gradient alone.
template <int d, int W>
inline Mat<d, Pack<W>> velocity_gradient(const BondTable<d>& t, const Field& v, Index pack) {
  using Real = Pack<W>;
  const Vec<d, Real> own = load_vector<d, W>(v, pack * W);
  Mat<d, Real> G = zero_tensor<d, Real>();
  for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
    Vec<d, Real> dv;
    for (int k = 0; k < d; ++k) dv[k] = Real::load(v[k] + j) - own[k];
    add_outer<d, Real>(G, dv, bond_vector<d, W>(t.stencil, n));
  });
  return G;
}

/// F of every slot.
template <int d>
void gradients_of_positions(const BondTable<d>& t, const Field& u, Field& F);

/// min over pairs of |x_ab| times the mean least stretch [m]: (62), (63) without the speed. Fills `stretch`.
template <int d>
double crossing_time_of(const BondTable<d>& t, const Field& u, const Field& F, Field& stretch);

/// H = cof F and J = det F of every slot, in three dimensions.
void tie(const Field& F, Field& H, Field& J, Index slots, int d);

/// True if both fields have the same numbers in all slots.
bool same_values(const Field& a, const Field& b, Index slots);

}  // namespace plumb
