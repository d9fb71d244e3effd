#include "lib/schemes/tlsph/boundary/open_forces.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "lib/schemes/tlsph/loops/evaluate.hpp"

namespace plumb {
namespace {

template <int d>
void keep(const Block& block, BlockForce<d>& force, Field& all) {
  for (int k = 0; k < d; ++k)
    std::copy_n(force.at(k, block.begin()), block.end() - block.begin(), all[k] + block.begin());
}

}  // namespace

template <int d>
OpenForces<d>::OpenForces(const Solid<d>& solid, const Actions<d>& actions)
    : terms_(solid.terms), actions_(actions) {
  std::erase_if(terms_, [](const Term<d>& term) { return term.name == "supports"; });
  for (std::size_t n = 0; n < actions_.held.size(); ++n) {
    for (const HeldPlace<d>& place : actions_.held[n].places)
      held_.push_back({solid.bonds.slots.of(place.particle), place.component, n, place.at});
    std::vector<HeldPlace<d>>().swap(actions_.held[n].places);
  }
  const auto key = [](const Entry& entry) { return std::tuple(entry.slot, entry.component); };
  std::sort(held_.begin(), held_.end(), [&](const Entry& a, const Entry& b) {  // the later boundary first
    return std::tuple(key(a), b.boundary) < std::tuple(key(b), a.boundary);
  });
  const auto same = [&](const Entry& a, const Entry& b) { return key(a) == key(b); };
  held_.erase(std::unique(held_.begin(), held_.end(), same), held_.end());
}

template <int d>
std::optional<Field> OpenForces<d>::at(const Solid<d>& solid, Workspace<d>& workspace,
                                       State<d>& state) const {
  Field open = solid.make_field(d);
  const Outcome outcome =
      evaluate(solid, terms_, workspace, state, state.time,
               [&](const Block& block, BlockForce<d>& force) { keep(block, force, open); });
  if (!outcome) return std::nullopt;
  return open;
}

template <int d>
Field OpenForces<d>::of_loads(const Solid<d>& solid, const Workspace<d>& workspace,
                              const State<d>& state) const {
  Field loads = solid.make_field(d);
  const auto term =
      std::find_if(terms_.begin(), terms_.end(), [](const Term<d>& t) { return t.name == "loads"; });
  if (term == terms_.end()) return loads;
  for (Index b = 0; b < solid.blocks(); ++b) {
    const Block block = solid.block(b);
    BlockForce<d> force(block);
    for (int k = 0; k < d; ++k) std::fill_n(force.at(k, block.begin()), block.end() - block.begin(), 0.0);
    term->second(solid, block, {state, state.time, workspace, terms_}, force);
    keep(block, force, loads);
  }
  return loads;
}

template <int d>
std::vector<Vec<d>> OpenForces<d>::reactions(const Solid<d>& solid, const State<d>& state,
                                             const Field& open) const {
  std::vector<Vec<d>> forces(actions_.held.size(), Vec<d>::Zero());
  for (const Entry& entry : held_) {
    const Held<d>& boundary = actions_.held[entry.boundary];
    const double acceleration =
        boundary.steady ? 0 : boundary.motion(entry.at, entry.component, state.time).acceleration;
    forces[entry.boundary][entry.component] +=
        solid.volume[entry.slot] * (solid.elastic.density * acceleration - open[entry.component][entry.slot]);
  }
  return forces;
}

template class OpenForces<1>;
template class OpenForces<2>;
template class OpenForces<3>;

}  // namespace plumb
