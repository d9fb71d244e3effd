#pragma once
#include "lib/core/types.hpp"

namespace plumb {

/// Twice the area of the triangle a b c, positive if it is counterclockwise.
inline double orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether the edge b c goes back along a b: they make no angle.
inline bool folds_back(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return orientation(a, b, c) == 0 && (b - a).dot(c - b) < 0;
}

/// Whether the segments a b and c d have a point in common, ends included.
inline bool segments_meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
  const Vec<2> lower = a.cwiseMin(b).cwiseMax(c.cwiseMin(d)), upper = a.cwiseMax(b).cwiseMin(c.cwiseMax(d));
  if (lower[0] > upper[0] || lower[1] > upper[1]) return false;  // not even their boxes
  const double ca = orientation(c, d, a), cb = orientation(c, d, b), ac = orientation(a, b, c),
               ad = orientation(a, b, d);
  return ((ca <= 0 && cb >= 0) || (ca >= 0 && cb <= 0)) && ((ac <= 0 && ad >= 0) || (ac >= 0 && ad <= 0));
}

}  // namespace plumb
