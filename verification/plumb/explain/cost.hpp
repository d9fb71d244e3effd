#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/scene/scene.hpp"

namespace plumb::app {

/// What one optional part costs a scene, or spares it if it is left out. Measured: a body of the same kind,
/// small and free, is built and stepped with the part and without it.
struct PartCost {
  std::string part;
  bool built;
  double bytes_per_particle;         ///< of arrays and bond constants, with less without
  double time_ratio;                 ///< time of a step with the part over that without it
  std::optional<double> step_ratio;  ///< dt with the part over dt without it, where it caps the step

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("part", self.part);
    visit("built", self.built);
    visit("bytes_per_particle", self.bytes_per_particle);
    visit("step_time_ratio", self.time_ratio);
    visit("dt_ratio", self.step_ratio);
  }
};

/// The parts that cost memory or time in every step: dissipation, hourglass energy, wave speed of the
/// stretch.
struct Costs {
  long particles;  ///< of the body measured
  std::vector<PartCost> parts;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("particles", self.particles);
    visit("parts", self.parts);
  }
};
Costs measure_costs(const Scene& scene);

}  // namespace plumb::app
