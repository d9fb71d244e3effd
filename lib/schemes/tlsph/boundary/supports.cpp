#include "lib/schemes/tlsph/boundary/supports.hpp"

#include <algorithm>

namespace plumb {

template <int d>
std::vector<Index> particles_on_face(const Cloud<d>& cloud, int axis, bool upper, Layout layout) {
  const double face = cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0);
  // cell layout: the first layer is half a spacing inside (less than one even with jitter), the second one
  // and a half
  const double reach = (layout == Layout::node ? 1e-6 : 0.9) * cloud.spacing;
  return particles_where<d>(cloud, [&](const Vec<d>& X) { return std::abs(X[axis] - face) < reach; });
}

template <int d>
std::vector<Index> particles_where(const Cloud<d>& cloud,
                                   const std::function<bool(const Vec<d>&)>& predicate) {
  std::vector<Index> found;
  for (Index i = 0; i < cloud.size(); ++i)
    if (predicate(cloud.X[i])) found.push_back(i);
  return found;
}

template <int d>
Actions<d> holding(const Cloud<d>& cloud, const std::vector<Support<d>>& supports) {
  Actions<d> actions;
  for (const Support<d>& support : supports) {
    const double velocity = support.velocity;
    auto held = std::find_if(actions.held.begin(), actions.held.end(), [&](const Held<d>& other) {
      return other.motion({}, 0, 0).velocity == velocity;
    });
    if (held == actions.held.end()) {
      const auto constant = [velocity](const Vec<d>&, int, double) -> HeldMotion {
        return {{}, velocity, 0};
      };
      held = actions.held.insert(held, {"supports", {}, constant, true});
    }
    held->places.push_back({support.particle, support.component, cloud.X[support.particle]});
  }
  return actions;
}

template <int d>
std::vector<Support<d>> supports_of(const Actions<d>& actions) {
  std::vector<Support<d>> supports;
  supports.reserve(held_components(actions));
  for (const auto& held : actions.held)
    for (const auto& place : held.places)
      supports.push_back(
          {place.particle, place.component, held.motion(place.at, place.component, 0).velocity});
  return supports;
}

template std::vector<Index> particles_on_face<1>(const Cloud<1>&, int, bool, Layout);
template std::vector<Index> particles_on_face<2>(const Cloud<2>&, int, bool, Layout);
template std::vector<Index> particles_on_face<3>(const Cloud<3>&, int, bool, Layout);
template std::vector<Index> particles_where<1>(const Cloud<1>&, const std::function<bool(const Vec<1>&)>&);
template std::vector<Index> particles_where<2>(const Cloud<2>&, const std::function<bool(const Vec<2>&)>&);
template std::vector<Index> particles_where<3>(const Cloud<3>&, const std::function<bool(const Vec<3>&)>&);
template Actions<1> holding<1>(const Cloud<1>&, const std::vector<Support<1>>&);
template Actions<2> holding<2>(const Cloud<2>&, const std::vector<Support<2>>&);
template Actions<3> holding<3>(const Cloud<3>&, const std::vector<Support<3>>&);
template std::vector<Support<1>> supports_of<1>(const Actions<1>&);
template std::vector<Support<2>> supports_of<2>(const Actions<2>&);
template std::vector<Support<3>> supports_of<3>(const Actions<3>&);

}  // namespace plumb
