#pragma once
#include "lib/geometry/cloud.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {
class Section;

/// Reads [body] file: particles that another program placed, in the formats of read_points(), with their
/// volumes where the file has them. `unit` is that of its lengths. The body's shape bounds the cells of
/// particles without volume; where none is given it is the box around the points. Refuses points that
/// coincide, lie outside of the shape or, in 2D, have a third coordinate, and keys that say where particles
/// are.
void read_cloud_file(const Section& section, Body& body, int dimension);

/// The particles that were read, with the volumes of the file or of their Voronoi cells within the shape.
template <int d>
Cloud<d> cloud_of_file(const Body& body);

}  // namespace plumb
