#pragma once
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// A flat piece of a body's surface that belongs to one particle: where its Voronoi cell meets the surface.
template <int d>
struct Facet {
  Index owner;       ///< particle number
  Vec<d> centroid;   ///< [m]
  Vec<d> area;       ///< outward normal times area [m^(d-1)]; in 1D +1 or -1
  double depth = 0;  ///< of the owner below the facet [m]; 0: it lies on this part of the surface
};

/// Facets of the Voronoi cells on the faces of the box; exact in 1D, voro++ in 2D and 3D. Throws InputError
/// for a particle outside of the box.
template <int d>
std::vector<Facet<d>> voronoi_facets(const std::vector<Vec<d>>& X, const Box<d>& box);

/// Facets of a lattice that fills its box, without rounding: products of cell sizes.
template <int d>
std::vector<Facet<d>> lattice_facets(const Cloud<d>& cloud);

/// Facets on the cloud's box, by whichever of the two applies.
template <int d>
std::vector<Facet<d>> box_facets(const Cloud<d>& cloud) {
  return cloud.line > 0 ? lattice_facets(cloud) : voronoi_facets<d>(cloud.X, cloud.box);
}

}  // namespace plumb
