#pragma once
#include "lib/geometry/cloud.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {
class Section;

/// The file of [body] file, as it stands or from the folder of the scene.
std::string file_beside_scene(const Section& section);

/// What one unit of the file's lengths is in metres: the key `unit`, or 1.
double metres_of_unit(const Section& section);

/// Reads [body] file: particles that another program placed, in the formats of read_points(), with their
/// volumes where the file has them. `unit` is that of its lengths. The body's shape bounds the cells of
/// particles without volume; where none is given it is the box around the points. Refuses points that
/// coincide, lie outside of the shape or, in 2D, have a third coordinate, holes that neither the shape nor
/// volumes explain, and keys that say where particles are.
void read_cloud_file(const Section& section, Body& body, int dimension);

/// Whether a file is a surface (STL) and holds no particles.
bool is_surface_file(const std::string& name);

/// Reads [body] file: an STL surface, in 2D one of flat triangles, of which the outline counts. It becomes
/// the shape "polyhedron" or "polygon" with holes, in metres. Refuses surfaces that are open or meet
/// themselves, and keys of other shapes.
void read_surface_file(const Section& section, Body& body, int dimension);

/// The particles that were read, with the volumes of the file or of their Voronoi cells within the shape.
template <int d>
Cloud<d> cloud_of_file(const Body& body);

}  // namespace plumb
