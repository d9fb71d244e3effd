#pragma once
#include "lib/schemes/tlsph/bonds/kinds.hpp"

namespace plumb {

/// A bond of one particle in memory; what is packed later.
template <int d>
struct SlotBond {
  std::int32_t offset;
  Vec<d> separation, stencil, force;
  double laplacian, outer_laplacian;
  Vec<d> signs = Vec<d>::Ones();  ///< of the reflection, if it leads to an image
};

/// The bonds of one particle and its sums over them. Bonds to images are apart; their share of the internal
/// force is image_force, not own_force. No two of them share offset and signs: images of one particle behind
/// opposite walls are 2 L apart, if the walls are L apart, and a support that is wider than L is refused.
template <int d>
struct SlotRow {
  std::vector<SlotBond<d>> bonds, images;
  Mat<d> identity = Mat<d>::Zero();
  Vec<d> own_force = Vec<d>::Zero(), image_force = Vec<d>::Zero();
  double own_outer = 0;
};

/// Row of particle i. `bonds`: of the representatives of `kinds`.
template <int d>
SlotRow<d> slot_row(Index i, const Surroundings<d>& seen, const Kinds& kinds,
                    const std::vector<std::vector<BondConstants<d>>>& bonds, const BondOptions<d>& options);

}  // namespace plumb
