#pragma once
#include "lib/schemes/tlsph/bonds/bond_table.hpp"

/// Reads a bond table particle by particle, for whoever is not in a hurry: nobody but the loops of the solver
/// needs to know of rows, packs and lanes.
namespace plumb {

/// Describes one bond of a particle i, or one of its bonds to mirror images.
template <int d>
struct BondEntry {
  Index other;          ///< slot of j
  std::int64_t number;  ///< of the bond in its table
  Index lane;           ///< of i in its pack
  int width;            ///< slots per pack

  /// Place in arrays of one number per bond and lane.
  Index place() const { return number * width + lane; }
  /// The bond's number or vector in an array of the table (weights [1/m^2]; separation [m], constants [1/m]).
  double value(const AlignedVector& values) const { return values[place()]; }
  Vec<d> vector(const AlignedVector& values) const {
    Vec<d> v;
    for (int k = 0; k < d; ++k) v[k] = values[(number * d + k) * width + lane];
    return v;
  }
};

/// Calls use(bond, X_ij) for every bond of the particle in this slot, in the order of the table.
template <int d, class Use>
void for_each_bond(const BondTable<d>& t, Index slot, Use&& use) {
  const Index row = t.row[slot / t.width];
  for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n) {
    const BondEntry<d> bond{slot + t.offset[n], n, slot % t.width, t.width};
    const Vec<d> X = bond.vector(t.separation);
    if (X.squaredNorm() > 0) use(bond, X);  // 0: this lane has no such neighbour
  }
}

/// Calls use(bond, R) for every bond of the particle to a mirror image; R: diagonal of the reflection. Places
/// that a lane does not have come with zero constants.
template <int d, class Use>
void for_each_image(const BondTable<d>& t, Index slot, Use&& use) {
  if (!t.mirror) return;
  const MirrorBonds<d>& m = *t.mirror;
  const Index row = t.row[slot / t.width];
  for (std::int64_t n = m.begin[row]; n < m.begin[row + 1]; ++n)
    use(BondEntry<d>{slot + m.offset[n], n, slot % t.width, t.width}, m.signs[n]);
}

/// sum_j X_ij (x) c_ij of the particle in this slot: I for every consistent estimator.
template <int d>
Mat<d> estimated_identity(const BondTable<d>& t, Index slot) {
  const Index row = t.row[slot / t.width], lane = slot % t.width;
  Mat<d> M;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) M(a, b) = t.identity[((row * d + a) * d + b) * t.width + lane];
  return M;
}

}  // namespace plumb
