#pragma once
#include <functional>
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// One Voronoi cell within a box: a convex body.
template <int d>
struct VoronoiCell {
  Index owner;  ///< particle number
  double volume;
  /// Corners of every face in order [m]: two in 2D, at least three in 3D.
  std::vector<std::vector<Vec<d>>> faces;
  /// Beyond each face: a particle's number, or -1 - k on face k of the box (x-, x+, y-, ..).
  std::vector<Index> beyond;
};

/// Calls `use` for the cell of every particle, in no promised order. `with_faces`: false leaves faces and
/// beyond empty. 2D and 3D. Throws InputError for a particle outside of the box or where another one is.
template <int d>
void for_each_voronoi_cell(const std::vector<Vec<d>>& X, const Box<d>& box, bool with_faces,
                           const std::function<void(const VoronoiCell<d>&)>& use);

}  // namespace plumb
