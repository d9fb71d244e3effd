#pragma once
#include "plumbline/gradient/bond_table.hpp"

namespace plumb {

/// The bonds of a lattice in the order that the processor likes; made from a BondTable of width > 1, equal to
/// it up to rounding.
///
/// Deformation gradient: where the stencil of a whole pack is antisymmetric, c(+o) = -c(-o), the two bonds
/// are one entry, F += (u(i+o) - u(i-o)) (x) c: half the weights and products. The rest are single entries,
/// (u(i+o) - u(i)) (x) c.
///
/// Force: f_i = sum_j P_j a_ij reads 26 x 9 stresses a particle, nearly all from addresses that straddle two
/// cache lines. With offset = aligned + shift (aligned a multiple of the pack width, |shift| <= width/2) it
/// becomes
///     f(i) = sum_shift S_shift(i + shift),   S_shift(s) = sum_aligned P(s + aligned) a(s - shift, aligned +
///     shift):
/// only the few sums S are read unaligned. Entries whose weight is zero on all lanes are left out (a third of
/// them). THEORY (10.1)-(10.3).
template <int d>
struct LatticeTable {
  int width = 1;
  // deformation gradient; rows as in the BondTable
  std::vector<std::int64_t> pair_begin, single_begin;  ///< per row, one more at the end
  std::vector<std::int32_t> pair_offset, single_offset;
  AlignedVector pair_stencil, single_stencil;  ///< d x width per entry [1/m]

  // force; a row per kind of source pack
  struct Sum {
    std::int32_t shift;      ///< slot of the target's partner minus slot of the source's line position
    std::int32_t component;  ///< b of P(a, b)
    std::int64_t end;        ///< one past its last entry
  };
  std::vector<std::int32_t> force_row;    ///< per pack
  std::vector<std::int64_t> sum_begin;    ///< per force row, one more at the end
  std::vector<std::int64_t> entry_begin;  ///< per force row: first entry of its first sum
  std::vector<Sum> sums;
  std::vector<std::int32_t> entry_offset;  ///< aligned
  AlignedVector entry_weight;              ///< width per entry [1/m]
  int most_shift = 0;

  std::size_t bytes() const;
};

template <int d>
LatticeTable<d> make_lattice_table(const BondTable<d>& bonds);

}  // namespace plumb
