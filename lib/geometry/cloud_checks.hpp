#pragma once
#include <optional>

#include "lib/geometry/shape.hpp"

namespace plumb {

/// A place in a body that no particle is near to.
template <int d>
struct Gap {
  Vec<d> at;
  double radius;   ///< distance of the nearest particle [m]
  double spacing;  ///< distance of that particle to its (2d)-th neighbour [m]
};

/// The widest place within the shape, in spacings, whose nearest particle is more than two local spacings
/// away: more than the random gaps of jittered lattices, blue noise and graded clouds. Seen if it is wider
/// than three mean spacings. Nothing if there is none, or fewer particles than neighbours that are asked for.
template <int d>
std::optional<Gap<d>> widest_gap(const std::vector<Vec<d>>& X, const Shape<d>& shape, double spacing);

/// Fills in count and stride if the particles are the nodes of a lattice over their box, numbered along the
/// axes in any sequence of them.
template <int d>
void find_lattice(Cloud<d>& cloud);

}  // namespace plumb
