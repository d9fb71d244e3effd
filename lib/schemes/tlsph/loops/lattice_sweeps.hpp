#pragma once
#include "lib/material/material.hpp"
#include "lib/schemes/tlsph/loops/lattice_table.hpp"
#include "lib/schemes/tlsph/loops/sweeps.hpp"

namespace plumb {

/// Deformation gradients of one pack of a lattice: the sum of THEORY (3.1) with antisymmetric bonds taken in
/// pairs.
template <int d, int W>
inline Mat<d, Pack<W>> lattice_deformation_gradient(const BondTable<d>& bonds, const LatticeTable<d>& table,
                                                    const Field& u, Index pack) {
  using Real = Pack<W>;
  const Index i = pack * W;
  const Index row = bonds.row[pack];
  Real F[d][d];
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) F[a][b] = Real::load(bonds.identity.data() + ((row * d + a) * d + b) * W);
  const auto add = [&](const double* weights, auto&& difference) {
    Real weight[d];
    for (int b = 0; b < d; ++b) weight[b] = Real::load_once(weights + b * W);
    for (int a = 0; a < d; ++a) {
      const Real du = difference(a);
      for (int b = 0; b < d; ++b) F[a][b] += du * weight[b];
    }
  };
  const std::int64_t pairs = table.pair_begin[row + 1];
  for (std::int64_t n = table.pair_begin[row]; n < pairs; ++n) {
    const Index o = table.pair_offset[n];
    add(table.pair_stencil.data() + n * d * W,
        [&](int a) { return Real::load(u[a] + i + o) - Real::load(u[a] + i - o); });
  }
  const std::int64_t singles = table.single_begin[row + 1];
  for (std::int64_t n = table.single_begin[row]; n < singles; ++n) {
    const Index o = table.single_offset[n];
    add(table.single_stencil.data() + n * d * W,
        [&](int a) { return Real::load(u[a] + i + o) - Real::load(u[a] + i); });
  }
  Mat<d, Real> result;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) result(a, b) = F[a][b];
  return result;
}

/// Internal force of one block of a lattice: the same as force_sweep, with aligned reads.
template <int d>
void lattice_force_sweep(const LatticeTable<d>& table, const StressWindow& P, const Block& block,
                         BlockForce<d>& force);

}  // namespace plumb
