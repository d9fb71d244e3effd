#include "lib/run/probe.hpp"

#include <limits>

namespace plumb {

template <int d>
std::vector<BoundProbe> bind_probes(const std::vector<Probe>& probes, const std::vector<Vec<d>>& X) {
  std::vector<BoundProbe> bound;
  for (const auto& probe : probes) {
    BoundProbe nearest{probe.name, 0, std::numeric_limits<double>::max(), probe.at};
    for (Index i = 0; i < static_cast<Index>(X.size()); ++i) {
      const double distance = (X[i] - Eigen::Map<const Vec<d>>(probe.at.data())).norm();
      if (distance < nearest.distance) nearest = {probe.name, i, distance, probe.at};
    }
    bound.push_back(nearest);
  }
  return bound;
}

template std::vector<BoundProbe> bind_probes<1>(const std::vector<Probe>&, const std::vector<Vec<1>>&);
template std::vector<BoundProbe> bind_probes<2>(const std::vector<Probe>&, const std::vector<Vec<2>>&);
template std::vector<BoundProbe> bind_probes<3>(const std::vector<Probe>&, const std::vector<Vec<3>>&);

}  // namespace plumb
