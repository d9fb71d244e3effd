#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/run/run.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {

/// When a run counts as unstable, beside J <= 0, numbers that are not finite and a collapsed time step.
struct StabilityBounds {
  std::optional<double> energy_growth;  ///< total energy above (1 + this) times the initial one
  std::optional<double> hourglass;  ///< share of the deformation that neighbouring gradients do not explain
};

/// How one run of a scene ended.
struct Trial {
  std::optional<Cause> cause;  ///< none: stable to the end
  double time = 0;             ///< reached [s]
  long steps = 0;
  /// Edge of the body's box over that at the start, for the axis where that is largest; of a body that is
  /// pulled, the box around the particles that supports hold and move.
  double stretch = 1;
  double hourglass = 0;  ///< share in the last state
  double energy = 1;     ///< total energy of the last state over the initial one; 0 without initial energy
  double cpu = 0;        ///< [s]
  std::string refused = {};  ///< why the scene cannot be built; then nothing was run
  bool stable() const { return !cause && refused.empty(); }
};

/// Runs the scene to its end or its failure, on this thread's share of the machine. `go_on` is asked at every
/// step; nothing is returned if it says no. A scene that cannot be built is refused, with the reason.
std::optional<Trial> try_scene(const Scene& scene, const StabilityBounds& bounds,
                               const std::function<bool()>& go_on);

}  // namespace plumb
