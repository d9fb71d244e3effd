#include "lib/schemes/tlsph/boundary/external_work.hpp"

#include <algorithm>
#include <utility>

#include "lib/schemes/tlsph/loops/step_weights.hpp"

namespace plumb {
namespace {

using Place = std::pair<Index, int>;  ///< slot and component

template <int d>
void add_all(const Solid<d>& solid, Index particle, std::vector<Place>& places) {
  for (int k = 0; k < d; ++k) places.emplace_back(solid.bonds.slots.of(particle), k);
}

template <int d>
std::vector<Place> everywhere(const Solid<d>& solid) {
  std::vector<Place> places;
  for (Index i = 0; i < solid.cloud.size(); ++i) add_all(solid, i, places);
  return places;
}

template <int d>
std::vector<Place> loaded_places(const Solid<d>& solid, const Actions<d>& actions) {
  if (!actions.body_forces.empty()) return everywhere(solid);
  std::vector<Place> places;
  for (const SurfaceLoad<d>& load : actions.surface)
    for (const LoadedPlace<d>& place : load.places) add_all(solid, place.particle, places);
  return places;
}

/// Components of supports that move at some time.
template <int d>
std::vector<Place> moved_places(const Solid<d>& solid, const Actions<d>& actions) {
  std::vector<Place> places;
  for (const Held<d>& held : actions.held)
    for (const HeldPlace<d>& place : held.places)
      if (!held.steady || held.motion(place.at, place.component, 0).velocity != 0)
        places.emplace_back(solid.bonds.slots.of(place.particle), place.component);
  return places;
}

template <int d>
std::vector<Place> places_of(const std::string& action, const Solid<d>& solid, const Actions<d>& actions) {
  std::vector<Place> places = action == "loads"      ? loaded_places(solid, actions)
                              : action == "damping"  ? everywhere(solid)
                              : action == "supports" ? moved_places(solid, actions)
                                                     : std::vector<Place>{};
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

/// What the terms and the account of one kind share.
template <int d>
struct ExternalWork<d>::Account {
  std::string action;
  std::vector<Place> places;
  StepWeights weights;
  std::vector<double> sum,
      last;                    ///< per place, weighed force of this step and of its last evaluation [N/m^d]
  std::vector<double> before;  ///< velocity at the start of the step [m/s]
  double done = 0;             ///< [J]
  bool holds = false;          ///< it prescribes the motion of its places

  /// Calls use(number of the place, force there) for the places of a block.
  template <class Use>
  void for_block(const Block& block, BlockForce<d>& force, Use&& use) {
    auto at = std::lower_bound(places.begin(), places.end(), Place(block.begin(), 0));
    for (; at != places.end() && at->first < block.end(); ++at)
      use(static_cast<std::size_t>(at - places.begin()), force(at->second, at->first));
  }
  void take_before(const Block& block, BlockForce<d>& force) {
    const double weighed = weights.of(block);
    for_block(block, force, [&](std::size_t n, double f) { last[n] = -weighed * f; });
  }
  void take_behind(const Block& block, BlockForce<d>& force) {
    const double weighed = weights.of(block);
    for_block(block, force, [&](std::size_t n, double f) {
      last[n] += weighed * f;
      sum[n] += last[n];
    });
  }
  /// Of supports, without the force that they prescribe: they make up for all that the velocity changes by.
  void take_reaction(const Block& block, BlockForce<d>& force) {
    const double weighed = weights.of(block);
    for_block(block, force, [&](std::size_t n, double f) {
      last[n] = -weighed * f;
      sum[n] += last[n];
    });
  }
  /// Impulse on a place over a step [kg m/s].
  double impulse(const Solid<d>& solid, std::size_t n, double dt, double now) const {
    const double by_forces = dt * sum[n];
    const double by_motion = holds ? solid.elastic.density * (now - before[n]) : 0;
    return solid.volume[places[n].first] * (by_forces + by_motion);
  }
  void start_step(const State<d>& state) {
    weights.start_step();
    for (std::size_t n = 0; n < places.size(); ++n) {
      sum[n] = weights.carries() ? last[n] : 0;
      before[n] = state.v[places[n].second][places[n].first];
    }
  }
};

template <int d>
ExternalWork<d>::ExternalWork(Solid<d>& solid, const Actions<d>& actions,
                              const ChosenIntegrator<d>& integrator, const State<d>& state)
    : time_(state.time) {
  if (integrator.weights.empty()) return;
  std::vector<Term<d>> terms;
  for (Term<d>& term : solid.terms) {
    const auto account = std::make_shared<Account>();
    account->action = term.name;
    account->places = places_of(term.name, solid, actions);
    if (account->places.empty()) {
      terms.push_back(std::move(term));
      continue;
    }
    account->holds = !term.held.empty();
    account->weights = StepWeights(integrator.weights, solid.blocks());
    account->sum.assign(account->places.size(), 0.0);
    account->last = account->before = account->sum;
    account->start_step(state);
    accounts_.push_back(account);
    Term<d> before, behind;
    before.name = behind.name = "work of " + term.name;
    before.second = [account](const Solid<d>&, const Block& block, const Instant<d>&, BlockForce<d>& force) {
      account->weights.count(block);
      account->holds ? account->take_reaction(block, force) : account->take_before(block, force);
    };
    behind.second = [account](const Solid<d>&, const Block& block, const Instant<d>&, BlockForce<d>& force) {
      account->take_behind(block, force);
    };
    terms.push_back(std::move(before));
    terms.push_back(std::move(term));
    if (!account->holds) terms.push_back(std::move(behind));
  }
  solid.terms = std::move(terms);
}

template <int d>
void ExternalWork<d>::close_step(const Solid<d>& solid, const State<d>& state) {
  const double dt = state.time - time_;
  time_ = state.time;
  for (const auto& account : accounts_) {
    double work = 0;
    for (std::size_t n = 0; n < account->places.size(); ++n) {
      const auto [slot, component] = account->places[n];
      const double now = state.v[component][slot];
      work += account->impulse(solid, n, dt, now) * 0.5 * (account->before[n] + now);
    }
    account->done += work;
    account->start_step(state);
  }
}

template <int d>
std::vector<WorkOf> ExternalWork<d>::done() const {
  std::vector<WorkOf> all;
  for (const auto& account : accounts_) all.push_back({account->action, account->done});
  return all;
}

template <int d>
std::vector<KeptWork> ExternalWork<d>::save() const {
  std::vector<KeptWork> saved;
  for (const auto& account : accounts_)
    saved.push_back(
        {account->action, account->done, account->weights.carries() ? account->last : std::vector<double>{}});
  return saved;
}

template <int d>
bool ExternalWork<d>::restore(const std::vector<KeptWork>& saved) {
  for (const auto& account : accounts_) {
    const auto from = std::find_if(saved.begin(), saved.end(),
                                   [&](const KeptWork& work) { return work.action == account->action; });
    const std::size_t needed = account->weights.carries() ? account->places.size() : 0;
    if (from == saved.end() || from->carried.size() != needed) return false;
    account->done = from->done;
    if (account->weights.carries()) account->sum = account->last = from->carried;
  }
  return true;
}

template class ExternalWork<1>;
template class ExternalWork<2>;
template class ExternalWork<3>;

}  // namespace plumb
