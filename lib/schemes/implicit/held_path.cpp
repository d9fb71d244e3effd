#include "lib/schemes/implicit/held_path.hpp"

#include <algorithm>
#include <utility>

namespace plumb {
namespace {

/// The integral of a prescribed velocity from 0 to `time` [m]: Simpson's rule on 64 intervals, which leaves
/// 1e-9 of a ramp, a polynomial of fifth degree.
template <int d>
double distance_gone(const Held<d>& held, const HeldPlace<d>& place, double time) {
  const auto velocity = [&](double t) { return held.motion(place.at, place.component, t).velocity; };
  if (held.steady) return time * velocity(0);
  constexpr int intervals = 64;
  const double step = time / intervals;
  double sum = velocity(0) + velocity(time);
  for (int n = 1; n < intervals; ++n) sum += (n % 2 ? 4 : 2) * velocity(n * step);
  return sum * step / 3;
}

}  // namespace

template <int d>
std::vector<Index> held_unknowns(const Actions<d>& actions) {
  std::vector<Index> held;
  for (const Held<d>& boundary : actions.held)
    for (const HeldPlace<d>& place : boundary.places) held.push_back(d * place.particle + place.component);
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

template <int d>
void put_held(const Actions<d>& actions, const PathPoint& at, const Eigen::VectorXd& start,
              Eigen::VectorXd& u) {
  for (const Held<d>& held : actions.held)
    for (const HeldPlace<d>& place : held.places) {
      const Index unknown = d * place.particle + place.component;
      const auto prescribed = held.motion(place.at, place.component, held.steady ? 0 : at.time).displacement;
      u[unknown] = prescribed ? (held.steady ? at.growth : 1) * *prescribed
                              : start[unknown] + distance_gone(held, place, at.time);
    }
}

template <int d>
std::vector<BoundaryForce<d>> forces_of_supports(const Actions<d>& actions, Eigen::VectorXd residual) {
  std::vector<BoundaryForce<d>> forces;
  for (const Held<d>& held : actions.held) forces.push_back({held.name, Vec<d>::Zero()});
  // of a component that two boundaries hold the later one has the force
  for (std::size_t n = forces.size(); n-- > 0;)
    for (const HeldPlace<d>& place : actions.held[n].places)
      forces[n].force[place.component] += std::exchange(residual[d * place.particle + place.component], 0.0);
  return forces;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                    \
  template std::vector<BoundaryForce<d>> forces_of_supports<d>(const Actions<d>&, Eigen::VectorXd); \
  template std::vector<Index> held_unknowns<d>(const Actions<d>&);                                  \
  template void put_held<d>(const Actions<d>&, const PathPoint&, const Eigen::VectorXd&, Eigen::VectorXd&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
