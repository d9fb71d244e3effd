#pragma once
#include "plumbline/geometry/shape.hpp"

namespace plumb {

/// A polygon of any form, given by its corners in order. 2D.
struct Polygon {
  static constexpr std::string_view name = "polygon";
  template <int d>
  static constexpr bool dimensions = d == 2;
  static std::vector<ShapeLength> lengths() { return {{"corners", ShapeLength::Kind::points}}; }

  std::vector<Vec<2>> corners;
  explicit Polygon(const ShapeLengths& l) {
    const auto& values = l.at("corners");
    for (std::size_t k = 0; k + 1 < values.size(); k += 2) corners.emplace_back(values[k], values[k + 1]);
    if (corners.size() < 3) throw InputError("a polygon of fewer than three corners", "it is empty", "");
  }

  /// A tenth larger than the polygon, so that no edge of it lies on a face of the box.
  template <int d>
  Box<d> box() const {
    Vec<2> lower = corners[0], upper = corners[0];
    for (const auto& corner : corners) {
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
    const Vec<2> margin = 0.05 * (upper - lower);
    return {lower - margin, upper - lower + 2 * margin};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    double square = std::numeric_limits<double>::infinity();
    bool inside = false;  // an odd number of edges crosses the ray along x
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
      const Vec<2> edge = b - a;
      const double t = std::clamp((X - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      square = std::min(square, (X - a - t * edge).squaredNorm());
      if ((a[1] > X[1]) != (b[1] > X[1]) && X[0] < a[0] + (X[1] - a[1]) / edge[1] * edge[0]) inside = !inside;
    }
    return inside ? -std::sqrt(square) : std::sqrt(square);
  }
};

}  // namespace plumb
