#pragma once
#include "plumbline/material/material.hpp"
#include "plumbline/solid/lattice_table.hpp"
#include "plumbline/solid/sweeps.hpp"

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
    for (int b = 0; b < d; ++b) weight[b] = Real::load(weights + b * W);
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

/// The sums S_shift of THEORY (10.3) over the packs of one block and one more on either side.
template <int d, int W>
class ShiftedSums {
 public:
  static constexpr int most_shift = W / 2;
  double* at(int shift, int component, Index pack_in_block) {
    return values_[shift + most_shift][component] + (pack_in_block + 1) * W;
  }

 private:
  alignas(64) double values_[2 * most_shift + 1][d][block_slots + 2 * W];
};

/// The sums of one source pack.
template <int d, int W>
inline void sum_sources(const LatticeTable<d>& table, const Field& P, Index pack, Index pack_in_block,
                        ShiftedSums<d, W>& sums) {
  using Real = Pack<W>;
  const Index i = pack * W;
  const Index row = table.force_row[pack];
  for (int shift = -table.most_shift; shift <= table.most_shift; ++shift)
    for (int a = 0; a < d; ++a) Real(0).store(sums.at(shift, a, pack_in_block));
  std::int64_t n = table.entry_begin[row];
  const std::int64_t end = table.sum_begin[row + 1];
  for (std::int64_t s = table.sum_begin[row]; s < end; ++s) {
    const auto& sum = table.sums[s];
    Real f[d];
    for (int a = 0; a < d; ++a) f[a] = Real::load(sums.at(sum.shift, a, pack_in_block));
    for (; n < sum.end; ++n) {
      const Real weight = Real::load(table.entry_weight.data() + n * W);
      for (int a = 0; a < d; ++a)
        f[a] += Real::load(P[a * d + sum.component] + i + table.entry_offset[n]) * weight;
    }
    for (int a = 0; a < d; ++a) f[a].store(sums.at(sum.shift, a, pack_in_block));
  }
}

/// Internal force of one block of a lattice: the same as force_sweep, with aligned reads.
template <int d, int W>
void lattice_force_sweep(const LatticeTable<d>& table, const Field& P, const Block& block,
                         BlockForce<d>& force) {
  using Real = Pack<W>;
  ShiftedSums<d, W> sums;
  const auto packs = static_cast<Index>(table.force_row.size());
  for (Index p = block.first_pack - 1; p <= block.end_pack; ++p) {
    const Index in_block = p - block.first_pack;
    if (p >= 0 && p < packs) {
      sum_sources<d, W>(table, P, p, in_block, sums);
      continue;
    }
    for (int shift = -table.most_shift; shift <= table.most_shift; ++shift)
      for (int a = 0; a < d; ++a) Real(0).store(sums.at(shift, a, in_block));
  }
  for (Index p = block.first_pack; p < block.end_pack; ++p)
    for (int a = 0; a < d; ++a) {
      Real f(0);
      for (int shift = -table.most_shift; shift <= table.most_shift; ++shift)
        f += Real::load(sums.at(shift, a, p - block.first_pack) + shift);
      f.store(force.at(a, p * W));
    }
}

}  // namespace plumb
