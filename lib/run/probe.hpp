#pragma once
#include <string>
#include <vector>

#include "lib/core/types.hpp"
#include "lib/run/output_options.hpp"

namespace plumb {

/// A probe of the scene, bound to the particle nearest to its reference point (the first one of equals).
struct BoundProbe {
  std::string name;
  Index particle;
  double distance;         ///< from the reference point to that particle [m]
  std::vector<double> at;  ///< the reference point [m]
};

/// X: reference positions of all particles [m].
template <int d>
std::vector<BoundProbe> bind_probes(const std::vector<Probe>& probes, const std::vector<Vec<d>>& X);

}  // namespace plumb
