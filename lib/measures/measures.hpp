#pragma once
#include <array>

#include "lib/particles/snapshot.hpp"

namespace plumb {

/// THEORY (8.2), (8.3). Three components also in 2D: p_z = 0, only L_z not zero. Angular: about the origin.
struct Momentum {
  std::array<double, 3> linear{};   ///< [kg m/s]
  std::array<double, 3> angular{};  ///< [kg m^2/s]
  double linear_scale = 0;          ///< sum m |v|, to judge a drift by
  double angular_scale = 0;         ///< sum m |x| |v|
};

/// Sums up linear and angular momentum, with the scales to which drifts are relative.
template <int d>
Momentum momentum_of(const Snapshot<d>& snapshot);

/// Smallest box around the current positions [m].
template <int d>
struct Extent {
  Vec<d> lower, upper;
};
template <int d>
Extent<d> extent_of(const Snapshot<d>& snapshot);

}  // namespace plumb
