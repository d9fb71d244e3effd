#pragma once
#include <optional>
#include <vector>

#include "lib/input/expression.hpp"

namespace plumb {

class Section;

/// Chooses the loads that act on every particle. It is the section [load] of a scene; without the section
/// there are none. Formulas of X, Y, Z (reference) and t.
struct LoadOptions {
  std::vector<Expression> gravity;     ///< force per mass [m/s^2]; one formula per axis, or empty
  std::vector<Expression> body_force;  ///< force per reference volume [N/m^d]; likewise
  std::optional<double> ramp;          ///< [s]: the loads grow smoothly from 0 to their values in this time
};

/// Reads [load]; nullopt without that section. Throws SceneError.
std::optional<LoadOptions> read_load(const Section& root, int dimension);

/// Returns the share of a load at `time` [s] that is ramped up in `ramp` [s]: 10 s^3 - 15 s^4 + 6 s^5 of s =
/// time/ramp, so that velocity and acceleration begin and end without a jump; 1 without a ramp.
double ramp_share(const std::optional<double>& ramp, double time);

}  // namespace plumb
