#include "lib/schemes/tlsph/parts/angular_momentum.hpp"

#include "lib/schemes/torque.hpp"

namespace plumb {

template <int d>
Term<d> angular_momentum_projection(const Solid<d>& solid) {
  const auto arms = std::make_shared<std::vector<Vec<3>>>(solid.cloud.size());  // then from their centre
  Term<d> term;
  term.name = "projection";
  term.bytes = arms->size() * sizeof(Vec<3>);
  // four passes: X and u read, x written; V, x, f read; V, f read, x changed; x read, f changed
  term.bytes_per_update = sizeof(double) * (5.0 * 3 + 2 + 6.0 * d);
  term.whole = [arms](const Solid<d>& body, const Instant<d>& now, const Arm<d>& arm, Field& force) {
    const Arm<d> at = arm ? arm : [&now](Index slot) { return vector_at<d>(now.state.u, slot); };
    take_torque_off(body.cloud, body.bonds.slots, at, *arms, force);
  };
  return term;
}

template Term<2> angular_momentum_projection<2>(const Solid<2>&);
template Term<3> angular_momentum_projection<3>(const Solid<3>&);

}  // namespace plumb
