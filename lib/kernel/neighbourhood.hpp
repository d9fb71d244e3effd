#pragma once
#include <span>

#include "lib/core/types.hpp"

namespace plumb {

/// One neighbour j as seen from particle i: X_ij = X_j - X_i [m] and V_j [m^d].
template <int d>
struct Neighbour {
  Vec<d> separation;
  double volume;
};

/// All particles inside the support of particle i, itself included (separation zero).
template <int d>
using Neighbourhood = std::span<const Neighbour<d>>;

}  // namespace plumb
