#pragma once
#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/core/error.hpp"
#include "lib/geometry/closed_surface.hpp"
#include "lib/geometry/flat_outlines.hpp"
#include "lib/input/number_table.hpp"
#include "lib/input/point_file.hpp"
#include "lib/input/stl.hpp"

/// What may be fed with any bytes: each function reads them as the program would. InputError is the one right
/// answer to bytes that cannot be used; anything else that is thrown, and anything accepted that breaks its
/// promise, is a fault.
namespace plumb::fuzz {

/// `what` must hold of whatever was accepted.
inline void promise(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("accepted, but ") + what);
}

/// The call with its one right kind of refusal taken as an answer.
template <class Target>
void feed(Target&& target, const std::string& bytes) {
  try {
    target(bytes);
  } catch (const InputError&) {
    return;
  }
}

inline void table(const std::string& bytes) {
  const NumberTable table = parse_numbers(bytes, "file");
  promise(!table.rows.empty(), "no rows");
  for (const auto& row : table.rows) {
    promise(row.size() == table.names.size(), "length of a row");
    for (const double value : row) promise(std::isfinite(value), "number");
  }
}

/// What was read of points is whole.
inline void whole(const PointFile& file) {
  promise(file.count > 0 && file.positions.size() == 3 * file.count, "positions");
  for (const double value : file.positions) promise(std::isfinite(value), "position");
  for (const PointColumn& column : file.columns) {
    promise(column.values.size() == file.count * static_cast<std::size_t>(column.components),
            "length of a column");
    for (const double value : column.values) promise(std::isfinite(value), "value");
  }
}

/// The first byte chooses the format: VTK by name, else what the bytes say.
inline void points(const std::string& bytes) {
  const bool vtk = !bytes.empty() && bytes[0] == '<';
  whole(parse_points(bytes, vtk ? "file.vtu" : "file.csv"));
}

/// An STL file as the surface of a body, and as the outline of one.
inline void surface(const std::string& bytes) {
  const std::vector<Triangle> triangles = parse_stl(bytes, "file.stl");
  promise(!triangles.empty(), "no triangles");
  std::vector<double> corners;
  for (const Triangle& triangle : triangles)
    for (const Vec<3>& corner : triangle) {
      promise(corner.allFinite(), "corner");
      corners.insert(corners.end(), corner.begin(), corner.end());
    }
  feed(
      [&](const std::string&) {
        for (const auto& outline : flat_outlines(triangles)) promise(outline.size() > 2, "outline");
      },
      "");
  TriangleMesh mesh = mesh_of_corners(corners);
  require_closed(mesh);
  const ClosedSurface closed(mesh);
  const Box<3> box = closed.box();
  promise((box.size.array() > 0).all(), "size of the box");
  if (closed.fills_its_box()) return;
  const double middle = closed.distance(box.origin + 0.5 * box.size);
  promise(!std::isnan(middle), "distance");
}

}  // namespace plumb::fuzz
