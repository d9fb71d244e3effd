#pragma once
#include <Eigen/Geometry>
#include <array>

#include "lib/core/types.hpp"

namespace plumb {

/// The nearest point of a triangle, and what of it that is.
struct NearestOfTriangle {
  enum class Feature { face, edge, corner };
  Vec<3> at;
  Feature feature = Feature::face;
  std::size_t number = 0;  ///< of the corner, or of the edge that begins there
};

/// The point of the triangle a b c nearest to X, by the regions of its corners and edges (Ericson 2005,
/// Real-Time Collision Detection, section 5.1.5).
inline NearestOfTriangle nearest_of_triangle(const std::array<Vec<3>, 3>& t, const Vec<3>& X) {
  using Feature = NearestOfTriangle::Feature;
  const Vec<3> ab = t[1] - t[0], ac = t[2] - t[0], ax = X - t[0], bx = X - t[1], cx = X - t[2];
  const double d1 = ab.dot(ax), d2 = ac.dot(ax), d3 = ab.dot(bx), d4 = ac.dot(bx), d5 = ab.dot(cx),
               d6 = ac.dot(cx);
  if (d1 <= 0 && d2 <= 0) return {t[0], Feature::corner, 0};
  if (d3 >= 0 && d4 <= d3) return {t[1], Feature::corner, 1};
  if (d6 >= 0 && d5 <= d6) return {t[2], Feature::corner, 2};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {t[0] + d1 / (d1 - d3) * ab, Feature::edge, 0};
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return {t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]), Feature::edge, 1};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {t[0] + d2 / (d2 - d6) * ac, Feature::edge, 2};
  const double scale = 1 / (va + vb + vc);
  return {t[0] + ab * (vb * scale) + ac * (vc * scale), Feature::face, 0};
}

}  // namespace plumb
