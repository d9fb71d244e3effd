#pragma once
#include <array>
#include <cmath>
#include <utility>

#include "lib/core/types.hpp"

namespace plumb {

/// A simplex (triangle, tetrahedron) with the signed distance to a surface at its corners. `wall` is the
/// corner opposite to a face that lies on the body's box, -1 if there is none.
template <int d>
struct Simplex {
  std::array<Vec<d>, d + 1> corner;
  std::array<double, d + 1> distance;
  int wall = -1;

  Vec<d> middle() const {
    Vec<d> sum = corner[0];
    for (int k = 1; k <= d; ++k) sum += corner[k];
    return sum / (d + 1);
  }

  double volume() const {
    Mat<d> edges;
    for (int k = 0; k < d; ++k) edges.col(k) = corner[k + 1] - corner[0];
    return std::abs(edges.determinant()) / (d == 2 ? 2 : 6);
  }

  /// Area vector of the face opposite to the corner, turned away from it (either way in a flat simplex).
  Vec<d> face(int opposite) const {
    std::array<Vec<d>, d> p;
    for (int k = 0, n = 0; k <= d; ++k)
      if (k != opposite) p[n++] = corner[k];
    Vec<d> area;
    if constexpr (d == 2) {
      area = Vec<d>(p[1][1] - p[0][1], p[0][0] - p[1][0]);
    } else {
      const Vec<d> a = p[1] - p[0], b = p[2] - p[0];  // cppcheck-suppress containerOutOfBounds
      area = 0.5 * Vec<d>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }
    return area.dot(corner[opposite] - p[0]) > 0 ? Vec<d>(-area) : area;
  }

  /// Centre of that face.
  Vec<d> face_middle(int opposite) const { return ((d + 1) * middle() - corner[opposite]) / d; }

  /// The longest edge as two corners, and its length.
  std::pair<std::pair<int, int>, double> longest_edge() const {
    std::pair<int, int> best{0, 1};
    double most = -1;
    for (int a = 0; a <= d; ++a)
      for (int b = a + 1; b <= d; ++b) {
        const double length = (corner[a] - corner[b]).norm();
        if (length > most) {
          most = length;
          best = {a, b};
        }
      }
    return {best, most};
  }

  /// The half in which the point on the edge replaces one of its ends (`gone`); the other end is `kept`.
  Simplex half(int gone, int kept, const Vec<d>& point, double distance_there) const {
    Simplex part = *this;
    part.corner[gone] = point;
    part.distance[gone] = distance_there;
    if (wall == kept) part.wall = -1;  // the face opposite to `kept` has moved inside
    return part;
  }
};

}  // namespace plumb
