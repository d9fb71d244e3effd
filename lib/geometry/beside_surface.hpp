#pragma once
#include "lib/core/types.hpp"

namespace plumb {

/// Where a point is with respect to a surface.
template <int d>
struct BesideSurface {
  double distance;  ///< [m], negative inside
  Vec<d> away;      ///< unit vector of the direction in which the distance grows
};

}  // namespace plumb
