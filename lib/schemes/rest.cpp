#include "lib/schemes/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

/// Calls use(component, slot) for all components of particles that move freely.
template <int d, class Use>
void for_each_free(const OutsideForces<d>& outside, Use&& use) {
  const auto& held = outside.held();
  std::size_t next = 0;
  for (Index i = 0; i < static_cast<Index>(outside.mass().size()); ++i)
    for (int k = 0; k < d; ++k) {
      const bool holds = next < held.size() && held[next].slot == i && held[next].component == k;
      holds ? static_cast<void>(++next) : use(k, i);
    }
}

}  // namespace

template <int d>
RestLook look_for_rest(const OutsideForces<d>& outside, const OpenAcceleration& before, const Field& u_before,
                       const OpenAcceleration& after, const Field& u_after) {
  const std::vector<double>& mass = outside.mass();
  const auto own = [](const OpenAcceleration& a, int k, Index i) {
    return a.loads.components() > 0 ? a.all[k][i] - a.loads[k][i] : a.all[k][i];
  };
  const auto square = [&](const Field& a, int k, Index i) { return std::pow(mass[i] * a[k][i], 2); };
  double unbalanced = 0, held = 0, loads = 0, back = 0, moved = 0;
  for_each_free(outside, [&](int k, Index i) {
    unbalanced += square(after.all, k, i);
    const double du = u_after[k][i] - u_before[k][i];
    back -= mass[i] * du * (own(after, k, i) - own(before, k, i));
    moved += mass[i] * du * du;
  });
  for (const auto& place : outside.held()) held += square(after.all, place.component, place.slot);
  for (int k = 0; k < after.loads.components(); ++k)
    for (Index i = 0; i < static_cast<Index>(mass.size()); ++i) loads += square(after.loads, k, i);
  const double scale = std::sqrt(std::max(held, loads));
  const double residual = unbalanced == 0 ? 0
                          : scale > 0     ? std::sqrt(unbalanced) / scale
                                          : std::numeric_limits<double>::infinity();
  return {residual, back > 0 && moved > 0 ? std::sqrt(back / moved) : 0};
}

template RestLook look_for_rest<1>(const OutsideForces<1>&, const OpenAcceleration&, const Field&,
                                   const OpenAcceleration&, const Field&);
template RestLook look_for_rest<2>(const OutsideForces<2>&, const OpenAcceleration&, const Field&,
                                   const OpenAcceleration&, const Field&);
template RestLook look_for_rest<3>(const OutsideForces<3>&, const OpenAcceleration&, const Field&,
                                   const OpenAcceleration&, const Field&);

}  // namespace plumb
