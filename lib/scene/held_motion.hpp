#pragma once
#include "lib/actions/actions.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {

/// Returns the motion that a boundary of kind clamped, roller, velocity or displacement prescribes for one
/// component at a point [m] and a time [s]. Rates of formulas are found by adaptive differences (GSL);
/// `time_scale` [s]: formulas change little in a thousandth of it.
HeldMotion prescribed_motion(const Boundary& boundary, const std::array<double, 3>& X, int component,
                             double time, double time_scale);

/// Says whether the prescribed velocity never changes.
bool is_steady(const Boundary& boundary);

}  // namespace plumb
