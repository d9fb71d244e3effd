#pragma once
#include "lib/schemes/tlsph/bonds/bond_table.hpp"

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
/// every stress is read once for all shifts, from an aligned address, and only the few sums S are read
/// unaligned. With S_{+k} = E_k + O_k, S_{-k} = E_k - O_k a stress inside the body belongs to the E or to the
/// O only, so that half of the products are gone. THEORY (10.1)-(10.4).
template <int d>
struct LatticeTable {
  int width = 1;
  // deformation gradient; rows as in the BondTable
  std::vector<std::int64_t> pair_begin, single_begin;  ///< per row, one more at the end
  std::vector<std::int32_t> pair_offset, single_offset;
  AlignedVector pair_stencil, single_stencil;  ///< d x width per entry [1/m]

  // force; a row per kind of source pack
  struct Source {
    std::int32_t offset;     ///< aligned
    std::int32_t component;  ///< b of P(a, b)
  };
  /// First the sources that belong to E_0 .. E_m (m+1 packs of weights each), then those of O_1 .. O_m (m
  /// packs), then those of both (2m+1 packs: E, then O).
  struct SourceRow {
    std::int64_t source, weight;      ///< where its sources and its weights start
    std::int32_t evens, odds, mixed;  ///< how many of each kind
  };
  int most_shift = 1;                   ///< m
  std::vector<std::int32_t> force_row;  ///< per pack, from the one before the first to that behind the last
  std::vector<SourceRow> source_rows;
  std::vector<Source> sources;
  AlignedVector source_weight;  ///< packs of weights [1/m]

  std::size_t bytes() const;
};

/// Makes the table of a lattice out of the table of its bonds.
template <int d>
LatticeTable<d> make_lattice_table(const BondTable<d>& bonds);

}  // namespace plumb
