#pragma once
#include "lib/geometry/shape.hpp"
#include "lib/schemes/tlsph/compatible/mesh_surface.hpp"

namespace plumb::mms {

/// Rings of particles over the annulus inner <= R <= outer about the origin, the first and the last on the
/// circles: equal steps in R of about `spacing`, the same number of particles on every ring, `spacing` apart
/// on the middle one. Volumes are exact ring sectors, half as deep on the circles. Not a lattice.
Cloud<2> polar_cloud(double inner, double outer, double spacing);

/// The two polygons whose corners are the first and the last ring of a polar cloud.
Surface<2> polar_surface(const Cloud<2>& polar, double inner, double outer);

/// The annulus as a shape, which clips a lattice or a random cloud (shaped_cloud).
Shape<2> annulus_shape(double inner, double outer);

}  // namespace plumb::mms
