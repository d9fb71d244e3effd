#pragma once
#include <optional>

namespace plumb {

class Section;

/// Chooses the hourglass energy, THEORY (12.1). It is the section [hourglass] of a scene or study; without
/// the section nothing of it is built.
struct HourglassOptions {
  double alpha =
      0.5;  ///< dimensionless; the larger, the less alternating motion and the stiffer a coarse bend
};

/// Reads [hourglass]; nullopt without that section, or if alpha is 0. Throws SceneError.
std::optional<HourglassOptions> read_hourglass(const Section& root);

}  // namespace plumb
