#pragma once
#include "lib/geometry/shape.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

namespace plumb {

/// The surface of a body of any shape: facets of the clipped Voronoi cells, with the volume and the centroid
/// of the clipped body.
template <int d>
Surface<d> clipped_surface(const Cloud<d>& cloud, const Shape<d>& shape);

/// The shape that particles without a known surface seem to fill: where the sum of spacing^d W(X - X_j), with
/// h = 1.2 spacings, exceeds one half. That is the region in which every particle is a cell of one spacing: a
/// lattice gets its surface half a spacing beyond its outer particles, with rounded corners. An estimate: its
/// error is a share of the spacing, and holes and gaps narrower than about two spacings close. Particles must
/// be spaced evenly; the cloud must outlive the shape.
template <int d>
Shape<d> shape_around(const Cloud<d>& cloud);

}  // namespace plumb
