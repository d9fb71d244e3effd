#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lib/core/types.hpp"
#include "lib/geometry/layout.hpp"

namespace plumb {

/// An axis-parallel box [m].
template <int d>
struct Box {
  Vec<d> origin;
  Vec<d> size;
};

/// Particles of the reference configuration.
template <int d>
struct Cloud {
  std::vector<Vec<d>> X;          ///< positions [m]
  std::vector<double> V;          ///< volumes [m^d]
  double spacing = 0;             ///< typical distance of neighbours d [m]
  Box<d> box;                     ///< the body's box, for faces
  Index line = 0;                 ///< lattices: particles per contiguous line; 0 for any other cloud
  std::vector<int> body;          ///< number (0, 1, ..) of each particle's body; empty: there is one
  std::array<Index, d> count{};   ///< lattices: particles along each axis
  std::array<Index, d> stride{};  ///< lattices: particle numbers from one to the next along each axis

  Index size() const { return static_cast<Index>(X.size()); }
};

/// Number of lattice cells per axis for a spacing. InputError if the spacing does not divide the size (to
/// 1e-6).
template <int d>
std::array<Index, d> cells_of(const Box<d>& box, double spacing);

/// A lattice that fills the box. cell: one particle in the middle of each cell, V = product of cell sizes.
/// node: a particle on each cell corner with tributary volumes (half on faces, quarter on edges, eighth at
/// corners). The longest axis runs fastest, so that lines of equal neighbourhoods are long.
template <int d>
Cloud<d> lattice(const Box<d>& box, const std::array<Index, d>& cells, Layout layout);

/// Moves every particle by up to `fraction` of the spacing in each direction (uniform, seeded; the same on
/// every machine) and gives it its Voronoi volume, clipped by the box. On node layouts the particles on faces
/// stay.
template <int d>
Cloud<d> jittered(Cloud<d> cloud, double fraction, std::uint64_t seed, Layout layout);

/// Voronoi volumes of the points inside the box [m^d]; exact in 1D, voro++ in 2D and 3D.
template <int d>
std::vector<double> voronoi_volumes(const std::vector<Vec<d>>& X, const Box<d>& box);

}  // namespace plumb
