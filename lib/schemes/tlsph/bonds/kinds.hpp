#pragma once
#include <cstdint>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/geometry/ghosts.hpp"
#include "lib/geometry/neighbours.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {

/// Particles as their neighbours see them. Images behind walls are numbered after the particles; without
/// walls there are none.
template <int d>
struct Surroundings {
  const Cloud<d>& cloud;         ///< with the images
  Slots slots;                   ///< of the particles
  std::vector<Ghost<d>> ghosts;  ///< in order
  Neighbours all;                ///< of particles and images

  Index particles() const { return slots.particles; }
  bool is_lattice() const { return slots.line > 0; }
  /// The image that j stands for; null if it is a particle.
  const Ghost<d>* ghost(Index j) const { return j < particles() ? nullptr : &ghosts[j - particles()]; }
  Index real(Index j) const { return j < particles() ? j : ghosts[j - particles()].real; }
  /// Number of the image of particle i behind the same walls.
  Index image(Index i, const Ghost<d>& behind) const;
};

/// For every particle the number of its kind, and for every kind one particle that stands for it.
struct Kinds {
  std::vector<std::int32_t> of;
  std::vector<Index> representative;
};

/// Every one on its own: clouds without repetition.
Kinds all_different(Index n);

/// Particles with the same separations and volumes (to 2^-30 of the spacing) at the same offsets are of one
/// kind.
template <int d>
Kinds kinds_by_neighbourhood(const Surroundings<d>& seen);

/// Particles whose bonds have the same constants (to 2^-30 of their size) at the same offsets are of one
/// kind. For clouds without images.
template <int d>
Kinds kinds_by_stencil(const Surroundings<d>& seen, const std::vector<std::vector<BondConstants<d>>>& bonds);

/// The row of particle i depends on its own kind and those of its neighbours.
template <int d>
Kinds kinds_by_neighbours(const Surroundings<d>& seen, const Kinds& own);

/// Packs of the same rows are of one kind.
Kinds kinds_of_packs(const Slots& slots, const std::vector<std::int32_t>& row_of_slot);

}  // namespace plumb
