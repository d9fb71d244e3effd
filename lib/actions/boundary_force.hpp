#pragma once
#include <string>

#include "lib/core/types.hpp"

namespace plumb {

/// The force of the supports of one boundary on the body [N] (per metre of thickness in 2D).
template <int d>
struct BoundaryForce {
  std::string boundary;
  Vec<d> force;
};

}  // namespace plumb
