#pragma once
#include <fmt/format.h>

#include <memory>

#include "lib/geometry/closed_surface.hpp"
#include "lib/geometry/shape.hpp"

namespace plumb {

/// A body of any form within triangles that close its surface: `corners` are three for each triangle. Which
/// side is outside is found. 3D. InputError if the surface is open or meets itself.
struct Polyhedron {
  static constexpr std::string_view name = "polyhedron";
  template <int d>
  static constexpr bool dimensions = d == 3;
  static std::vector<ShapeLength> lengths() {
    return {{"corners", "three corners of each triangle", ShapeLength::Kind::points}};
  }

  std::shared_ptr<const ClosedSurface> surface;
  explicit Polyhedron(const ShapeLengths& l) {
    const auto& corners = l.at("corners");
    if (corners.size() % 9 != 0 || corners.size() < 36)
      throw InputError(fmt::format("a polyhedron of {} corners", corners.size() / 3),
                       "each triangle has three, and four triangles are the fewest that close a surface", "");
    TriangleMesh mesh = mesh_of_corners(corners);
    require_closed(mesh);
    surface = std::make_shared<const ClosedSurface>(mesh);
  }

  template <int d>
  Box<d> box() const {
    return surface->box();
  }
  bool fills_its_box() const { return surface->fills_its_box(); }
  template <int d>
  double distance(const Vec<d>& X) const {
    return surface->distance(X);
  }
};

}  // namespace plumb
