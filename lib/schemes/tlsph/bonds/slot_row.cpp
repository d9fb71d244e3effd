#include "lib/schemes/tlsph/bonds/slot_row.hpp"

#include <algorithm>

namespace plumb {
namespace {

/// Position of particle j among the sorted neighbours of i, not counting i itself.
Index place_of(std::span<const std::int32_t> neighbours, Index i, Index j) {
  const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), static_cast<std::int32_t>(j));
  return (at - neighbours.begin()) - (j > i ? 1 : 0);
}

/// The bond from j back to i. From an image R j it is the reflection of the bond from j to the image R i.
template <int d>
BondConstants<d> reverse_bond(Index i, Index j, const Surroundings<d>& seen, const Kinds& kinds,
                              const std::vector<std::vector<BondConstants<d>>>& bonds) {
  const Ghost<d>* ghost = seen.ghost(j);
  const Index real = seen.real(j), back = ghost ? seen.image(i, *ghost) : i;
  BondConstants<d> bond = bonds[kinds.of[real]][place_of(seen.all.of(real), real, back)];
  if (ghost) {
    const Vec<d> signs = signs_of(*ghost);
    bond.stencil = bond.stencil.cwiseProduct(signs);
    bond.gradient = bond.gradient.cwiseProduct(signs);
  }
  return bond;
}

}  // namespace

template <int d>
SlotRow<d> slot_row(Index i, const Surroundings<d>& seen, const Kinds& kinds,
                    const std::vector<std::vector<BondConstants<d>>>& bonds, const BondOptions<d>& options) {
  const Cloud<d>& cloud = seen.cloud;
  SlotRow<d> row;
  const auto& mine = bonds[kinds.of[i]];
  std::size_t n = 0;
  for (const auto j : seen.all.of(i)) {
    if (j == i) continue;
    const BondConstants<d>& ij = mine[n++];
    const BondConstants<d> ji = reverse_bond(i, j, seen, kinds, bonds);
    const PairData<d> pair{cloud.V[i], cloud.V[j], ij.stencil, ji.stencil, ij.gradient, ji.gradient};
    const Ghost<d>* ghost = seen.ghost(j);
    SlotBond<d> bond;
    bond.offset = static_cast<std::int32_t>(seen.slots.of(seen.real(j)) - seen.slots.of(i));
    bond.separation = ij.separation;
    bond.stencil = ij.stencil;
    bond.force = options.momentum.other(pair);
    bond.laplacian = cloud.V[j] * ij.laplacian;
    bond.outer_laplacian =
        cloud.V[j] * (options.outer_transpose ? ji.laplacian : 0.5 * (ij.laplacian + ji.laplacian));
    row.own_outer += cloud.V[j] * (ji.laplacian - ij.laplacian);
    row.identity += ij.separation * ij.stencil.transpose();
    (ghost ? row.image_force : row.own_force) += options.momentum.own(pair);
    if (ghost) {
      bond.signs = signs_of(*ghost);
      row.images.push_back(bond);
    } else {
      row.bonds.push_back(bond);
    }
  }
  return row;
}

template SlotRow<1> slot_row<1>(Index, const Surroundings<1>&, const Kinds&,
                                const std::vector<std::vector<BondConstants<1>>>&, const BondOptions<1>&);
template SlotRow<2> slot_row<2>(Index, const Surroundings<2>&, const Kinds&,
                                const std::vector<std::vector<BondConstants<2>>>&, const BondOptions<2>&);
template SlotRow<3> slot_row<3>(Index, const Surroundings<3>&, const Kinds&,
                                const std::vector<std::vector<BondConstants<3>>>&, const BondOptions<3>&);

}  // namespace plumb
