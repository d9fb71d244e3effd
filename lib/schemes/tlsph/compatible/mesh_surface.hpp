#pragma once
#include <array>

#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

namespace plumb {

/// A closed surface whose corners are particles: d particle numbers per piece (2D: edges, 3D: triangles),
/// turned so that the outward normal of an edge is its direction turned by -90 degrees, and of a triangle
/// that of the right-hand rule.
template <int d>
using SurfaceMesh = std::vector<std::array<Index, d>>;

/// The surface of a body of any shape with particles on its boundary: each corner of a piece gets an equal
/// share of its area, which is exact for linear fields. Volume and centroid are those of the polyhedron.
template <int d>
Surface<d> mesh_surface(const Cloud<d>& cloud, const SurfaceMesh<d>& mesh);

}  // namespace plumb
