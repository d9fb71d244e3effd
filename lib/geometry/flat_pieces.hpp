#pragma once
#include <functional>
#include <vector>

#include "lib/geometry/shape.hpp"

namespace plumb {

/// The plane of a flat piece of a surface (in 2D the line of an edge).
template <int d>
struct Plane {
  Vec<d> point, normal;  ///< any point of it [m]; of length 1, to either side

  double side(const Vec<d>& X) const { return normal.dot(X - point); }
};

/// Appends the planes of flat pieces that come within a radius of X [m].
template <int d>
using PlanesNear = std::function<void(const Vec<d>& X, double radius, std::vector<Plane<d>>& planes)>;

/// A signed distance that knows the flat pieces of its surface. A Shape with such a clip has exact corners. A model of the
/// catalogue gets one if it has flats<d>(X, radius, planes), which is PlanesNear.
template <int d>
struct ClipWithPlanes {
  std::function<double(const Vec<d>&)> distance;
  PlanesNear<d> near;

  double operator()(const Vec<d>& X) const { return distance(X); }
};

/// Appends the planes of the flat pieces of a shape's clip that come within the radius; none if it knows none.
template <int d>
void planes_near(const Shape<d>& shape, const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) {
  if (const auto* clip = shape.clip.template target<ClipWithPlanes<d>>()) clip->near(X, radius, planes);
}

}  // namespace plumb
