#include "lib/measures/measures.hpp"

#include "lib/measures/over_particles.hpp"

namespace plumb {

template <int d>
Momentum momentum_of(const Snapshot<d>& s) {
  return momentum_over<d>(static_cast<Index>(s.x.size()), [&](Index i) {
    return MovingMass<d>{s.mass[i], s.x[i], s.v[i]};
  });
}

template <int d>
Extent<d> extent_of(const Snapshot<d>& s) {
  return extent_over<d>(static_cast<Index>(s.x.size()), [&](Index i) { return s.x[i]; });
}

template Momentum momentum_of<1>(const Snapshot<1>&);
template Momentum momentum_of<2>(const Snapshot<2>&);
template Momentum momentum_of<3>(const Snapshot<3>&);
template Extent<1> extent_of<1>(const Snapshot<1>&);
template Extent<2> extent_of<2>(const Snapshot<2>&);
template Extent<3> extent_of<3>(const Snapshot<3>&);

}  // namespace plumb
