#pragma once
#include "plumbline/compatible/mesh_surface.hpp"

namespace plumb::mms {

/// Rings of particles over the annulus inner <= R <= outer about the origin, the first and the last on the
/// circles: equal steps in R of about `spacing`, the same number of particles on every ring, `spacing` apart
/// on the middle one. Volumes are exact ring sectors, half as deep on the circles. Not a lattice.
Cloud<2> polar_cloud(double inner, double outer, double spacing);

/// The two polygons whose corners are the first and the last ring of a polar cloud.
Surface<2> polar_surface(const Cloud<2>& polar, double inner, double outer);

/// The square lattice of cells of size `spacing` around the origin, clipped: a particle in each cell whose
/// middle lies in the annulus. Its volume is the part of the cell inside; parts of cells without a particle
/// are left out, so that the volumes add up to the annulus' up to a share of order spacing.
Cloud<2> clipped_cloud(double inner, double outer, double spacing);

}  // namespace plumb::mms
