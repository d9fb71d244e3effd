#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/geometry/crossing.hpp"

namespace plumb {

/// Six times the signed volume of the tetrahedron a b c d; zero where rounding of the corners decides.
inline double signed_volume(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
  const Vec<3> u = b - a, v = c - a, w = d - a;
  const double value = u.cross(v).dot(w);
  return std::abs(value) <= 1e-12 * u.norm() * v.norm() * w.norm() ? 0 : value;
}

/// Whether the segment p q and the triangle, which lie in one plane, have a point in common.
inline bool meet_in_plane(const Vec<3>& p, const Vec<3>& q, const std::array<Vec<3>, 3>& t) {
  int axis = 0;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  const auto flat = [axis](const Vec<3>& X) { return Vec<2>(X[(axis + 1) % 3], X[(axis + 2) % 3]); };
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<2> a = flat(t[k]), b = flat(t[(k + 1) % 3]);
    if (segments_meet(flat(p), flat(q), a, b)) return true;
    (orientation(a, b, flat(p)) > 0 ? left : right) = true;
  }
  return left != right;  // within: on one side of all edges
}

/// Whether the segment p q and the triangle have a point in common.
inline bool segment_meets(const Vec<3>& p, const Vec<3>& q, const std::array<Vec<3>, 3>& t) {
  const double of_p = signed_volume(t[0], t[1], t[2], p), of_q = signed_volume(t[0], t[1], t[2], q);
  if (of_p == 0 && of_q == 0) return meet_in_plane(p, q, t);
  if (of_p * of_q > 0) return false;
  std::array<double, 3> side;
  for (std::size_t k = 0; k < 3; ++k) side[k] = signed_volume(p, q, t[k], t[(k + 1) % 3]);
  return std::all_of(side.begin(), side.end(), [](double s) { return s >= 0; }) ||
         std::all_of(side.begin(), side.end(), [](double s) { return s <= 0; });
}

/// Whether two triangles have a point in common beyond the corners that they share. `mine` and `its` say
/// which those are. Triangles with a common edge meet if they lie on each other.
inline bool triangles_meet(const std::array<Vec<3>, 3>& a, const std::array<bool, 3>& mine,
                           const std::array<Vec<3>, 3>& b, const std::array<bool, 3>& its) {
  const auto shared = std::count(mine.begin(), mine.end(), true);
  const auto alone = [](const std::array<bool, 3>& of) {
    return static_cast<std::size_t>(std::find(of.begin(), of.end(), false) - of.begin());
  };
  if (shared == 3) return true;
  if (shared == 2) {
    const std::size_t k = alone(mine), m = alone(its);
    const Vec<3>&p = a[(k + 1) % 3], &q = a[(k + 2) % 3];
    if (signed_volume(p, q, a[k], b[m]) != 0) return false;
    return (q - p).cross(a[k] - p).dot((q - p).cross(b[m] - p)) > 0;  // the same side of the edge
  }
  // an edge that holds a shared corner ends there: with one shared corner only the edges across from it count
  for (std::size_t k = 0; k < 3; ++k) {
    if (!mine[k] && !mine[(k + 1) % 3] && segment_meets(a[k], a[(k + 1) % 3], b)) return true;
    if (!its[k] && !its[(k + 1) % 3] && segment_meets(b[k], b[(k + 1) % 3], a)) return true;
  }
  return false;
}

}  // namespace plumb
