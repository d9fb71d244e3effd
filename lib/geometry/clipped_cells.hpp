#pragma once
#include <vector>

#include "lib/geometry/facets.hpp"
#include "lib/geometry/shape.hpp"

namespace plumb {

/// What a shape leaves of the particles' Voronoi cells.
template <int d>
struct ClippedCells {
  std::vector<double> volume;    ///< [m^d]
  std::vector<Vec<d>> centroid;  ///< [m]; the particle itself where nothing is left
  std::vector<Facet<d>>
      facets;  ///< pieces of the surface, by owner; one for each direction that a cell meets
};

/// Voronoi cells clipped by the shape, in 2D and 3D. A cell is cut into simplices from its particle, those
/// near the surface are halved until no edge is longer than an eighth (3D: a quarter) of the mean spacing,
/// and each is cut along the planes of flat pieces (flat_pieces.hpp) and where its edges meet the surface; so
/// bodies of flat pieces are exact, corners included, and curved surfaces become polygons and polyhedra, exact
/// but for the sagitta of chords that short. Throws InputError for particles outside of the shape's box.
template <int d>
ClippedCells<d> clipped_cells(const std::vector<Vec<d>>& X, const Shape<d>& shape);

}  // namespace plumb
