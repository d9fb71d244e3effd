#include "plumb/run/probe.hpp"

#include <limits>

namespace plumb {

template <int d>
std::vector<BoundProbe> bind_probes(const std::vector<Probe>& probes, const Cloud<d>& cloud) {
  std::vector<BoundProbe> bound;
  for (const auto& probe : probes) {
    BoundProbe nearest{probe.name, 0, std::numeric_limits<double>::max(), probe.at};
    for (Index i = 0; i < cloud.size(); ++i) {
      const double distance = (cloud.X[i] - Eigen::Map<const Vec<d>>(probe.at.data())).norm();
      if (distance < nearest.distance) nearest = {probe.name, i, distance, probe.at};
    }
    bound.push_back(nearest);
  }
  return bound;
}

template std::vector<BoundProbe> bind_probes<2>(const std::vector<Probe>&, const Cloud<2>&);
template std::vector<BoundProbe> bind_probes<3>(const std::vector<Probe>&, const Cloud<3>&);

}  // namespace plumb
