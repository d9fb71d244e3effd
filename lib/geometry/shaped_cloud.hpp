#pragma once
#include <cstdint>

#include "lib/geometry/shape.hpp"

namespace plumb {

/// How particles are put into a shape.
struct Filling {
  double spacing;                ///< [m]
  Layout layout = Layout::node;  ///< node: particles on the surface too; cell: inside only
  bool blue_noise = false;       ///< random points that keep a distance, instead of a lattice
  double jitter = 0;             ///< of particles inside, in spacings
  std::uint64_t seed = 1;        ///< the same on every machine
};

/// Particles in a shape, with the volumes of their clipped Voronoi cells. Lattice: the nodes (node) or
/// middles (cell) of cells over the shape's box that lie inside, on node layouts by at least half a spacing.
/// Node layouts also get particles on the surface: lattice nodes where they lie on it (faces of a box),
/// elsewhere random points that keep a distance; edges and corners of other bodies are not sought. Blue
/// noise: points are thrown, and kept if no other one is near (Poisson discs), about one per spacing^d.
/// Throws InputError if the shape holds no particle.
template <int d>
Cloud<d> shaped_cloud(const Shape<d>& shape, const Filling& filling);

}  // namespace plumb
