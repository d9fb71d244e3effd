#include "lib/schemes/tlsph/boundary/apply_actions.hpp"

#include <algorithm>
#include <memory>

namespace plumb {
namespace {

/// Entries of a block in a list that is sorted by slot.
template <class Entry>
auto first_in(const std::vector<Entry>& entries, Index slot) {
  return std::lower_bound(entries.begin(), entries.end(), slot,
                          [](const Entry& entry, Index value) { return entry.slot < value; });
}

template <class Entry>
void sort_by_slot(std::vector<Entry>& entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.slot < b.slot; });
  entries.shrink_to_fit();
}

template <int d>
struct SurfaceEntry {
  Index slot;
  std::size_t load;  ///< in Actions::surface
  Vec<d> at, normal;
  double per_volume;    ///< A/V [1/m]
  Vec<d> steady_value;  ///< of a steady traction [Pa]; component 0 of a steady pressure
};

/// All loads of a body, by slot.
template <int d>
struct Loads {
  Actions<d> actions;
  std::vector<SurfaceEntry<d>> surface;
  std::vector<Index>
      particle_of;  ///< per slot; -1 for empty slots. Empty without body forces that vary in time
  Field steady;     ///< sum of the steady body forces [N/m^d]; empty without one

  Vec<d> value(const SurfaceEntry<d>& entry, double time) const {
    const SurfaceLoad<d>& load = actions.surface[entry.load];
    if (load.traction) return load.traction(entry.at, entry.normal, time);
    Vec<d> pressure = Vec<d>::Zero();
    pressure[0] = load.pressure(entry.at, time);
    return pressure;
  }

  void add_body_forces(const Solid<d>& solid, const Block& block, double time, BlockForce<d>& force) const {
    if (steady.components())
      for (int k = 0; k < d; ++k)
        for (Index slot = block.begin(); slot < block.end(); ++slot) force(k, slot) += steady[k][slot];
    if (particle_of.empty()) return;
    for (Index slot = block.begin(); slot < block.end(); ++slot) {
      const Index i = particle_of[static_cast<std::size_t>(slot)];
      if (i < 0) continue;
      for (const BodyForce<d>& body : actions.body_forces) {
        if (body.steady) continue;
        const Vec<d> f = body.per_volume(solid.cloud.X[static_cast<std::size_t>(i)], time);
        for (int k = 0; k < d; ++k) force(k, slot) += f[k];
      }
    }
  }

  void add_surface_loads(const Block& block, const Instant<d>& now, BlockForce<d>& force) const {
    for (auto at = first_in(surface, block.begin()); at != surface.end() && at->slot < block.end(); ++at) {
      const SurfaceLoad<d>& load = actions.surface[at->load];
      Vec<d> t = load.steady ? at->steady_value : value(*at, now.time);
      if (load.pressure) t = -t[0] * (cofactor(gradient_at(now.workspace.F, at->slot)) * at->normal);
      for (int k = 0; k < d; ++k) force(k, at->slot) += at->per_volume * t[k];
    }
  }

  static Mat<d> gradient_at(const Field& F, Index slot) {
    Mat<d> result;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) result(a, b) = F[a * d + b][slot];
    return result;
  }
  /// cof F = det(F) F^-T, also of a singular F.
  static Mat<d> cofactor(const Mat<d>& F) {
    Mat<d> C;
    if constexpr (d == 1)
      C << 1;
    else if constexpr (d == 2)
      C << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
    else
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          C(a, b) = F((a + 1) % 3, (b + 1) % 3) * F((a + 2) % 3, (b + 2) % 3) -
                    F((a + 1) % 3, (b + 2) % 3) * F((a + 2) % 3, (b + 1) % 3);
    return C;
  }
};

template <int d>
std::shared_ptr<Loads<d>> make_loads(const Solid<d>& solid, const Actions<d>& actions) {
  auto made = std::make_shared<Loads<d>>();
  made->actions = actions;
  made->actions.held.clear();
  for (auto& load : made->actions.surface)
    std::vector<LoadedPlace<d>>().swap(load.places);  // they are in the entries
  for (std::size_t n = 0; n < actions.surface.size(); ++n)
    for (const LoadedPlace<d>& place : actions.surface[n].places) {
      SurfaceEntry<d> entry{solid.bonds.slots.of(place.particle),
                            n,
                            place.at,
                            place.normal(),
                            place.size() / solid.cloud.V[place.particle],
                            Vec<d>::Zero()};
      if (actions.surface[n].steady) entry.steady_value = made->value(entry, 0);
      made->surface.push_back(entry);
    }
  sort_by_slot(made->surface);
  bool varies = false;
  for (const BodyForce<d>& body : actions.body_forces) {
    varies = varies || !body.steady;
    if (!body.steady) continue;
    if (!made->steady.components()) made->steady = solid.make_field(d);
    for (Index i = 0; i < solid.cloud.size(); ++i) {
      const Index slot = solid.bonds.slots.of(i);
      set_vector<d>(made->steady, slot,
                    vector_at<d>(made->steady, slot) + body.per_volume(solid.cloud.X[i], 0));
    }
  }
  if (varies) {
    made->particle_of.assign(static_cast<std::size_t>(solid.bonds.slots.count()), -1);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      made->particle_of[static_cast<std::size_t>(solid.bonds.slots.of(i))] = i;
  }
  return made;
}

template <int d>
Term<d> load_term(const Solid<d>& solid, const Actions<d>& actions) {
  const auto loads = make_loads(solid, actions);
  Term<d> term;
  term.name = "loads";
  term.bytes = loads->surface.size() * sizeof(SurfaceEntry<d>) + loads->particle_of.size() * sizeof(Index) +
               loads->steady.bytes();
  term.needs_F = std::any_of(actions.surface.begin(), actions.surface.end(),
                             [](const auto& load) { return static_cast<bool>(load.pressure); });
  term.second = [loads](const Solid<d>& body, const Block& block, const Instant<d>& now,
                        BlockForce<d>& force) {
    loads->add_body_forces(body, block, now.time, force);
    loads->add_surface_loads(block, now, force);
  };
  return term;
}

template <int d>
struct HeldEntry {
  Index slot;
  int component;
  std::size_t held;  ///< in Actions::held
  Vec<d> at;
};

template <int d>
Term<d> held_term(const Solid<d>& solid, const Actions<d>& actions) {
  auto entries = std::make_shared<std::vector<HeldEntry<d>>>();
  for (std::size_t n = 0; n < actions.held.size(); ++n)
    for (const HeldPlace<d>& place : actions.held[n].places)
      entries->push_back({solid.bonds.slots.of(place.particle), place.component, n, place.at});
  sort_by_slot(*entries);
  const auto held = std::make_shared<std::vector<Held<d>>>(actions.held);
  for (Held<d>& boundary : *held)
    std::vector<HeldPlace<d>>().swap(boundary.places);  // they are in the entries
  Term<d> term;
  term.name = "supports";
  for (const HeldEntry<d>& entry : *entries) term.held.emplace_back(entry.slot, entry.component);
  std::sort(term.held.begin(), term.held.end());
  term.held.erase(std::unique(term.held.begin(), term.held.end()), term.held.end());
  term.bytes = entries->size() * sizeof(HeldEntry<d>) + term.held.size() * sizeof(term.held[0]);
  term.second = [entries, held](const Solid<d>& body, const Block& block, const Instant<d>& now,
                                BlockForce<d>& force) {
    for (auto at = first_in(*entries, block.begin()); at != entries->end() && at->slot < block.end(); ++at) {
      const Held<d>& boundary = (*held)[at->held];
      double& f = force(at->component, at->slot);
      f = 0;
      if (!boundary.steady)
        f = body.elastic.density * boundary.motion(at->at, at->component, now.time).acceleration;
    }
  };
  return term;
}

}  // namespace

template <int d>
void apply_actions(Solid<d>& solid, const Actions<d>& actions) {
  if (actions.has_loads()) add_term(solid, load_term(solid, actions));
  if (held_components(actions) > 0) add_term(solid, held_term(solid, actions));
}

template <int d>
void impose(const Solid<d>& solid, const Actions<d>& actions, State<d>& state, bool all) {
  for (const Held<d>& held : actions.held) {
    if (held.steady && !all) continue;
    for (const HeldPlace<d>& place : held.places) {
      const Index slot = solid.bonds.slots.of(place.particle);
      const HeldMotion motion = held.motion(place.at, place.component, state.time);
      state.v[place.component][slot] = motion.velocity;
      if (motion.displacement) state.u[place.component][slot] = *motion.displacement;
    }
  }
}

template <int d>
ChosenIntegrator<d> with_prescribed_motion(ChosenIntegrator<d> integrator, const Actions<d>& actions) {
  const bool moves = std::any_of(actions.held.begin(), actions.held.end(),
                                 [](const Held<d>& held) { return !held.steady && !held.places.empty(); });
  if (!moves) return integrator;
  integrator.step = [inner = integrator.step, actions](const Solid<d>& solid, State<d>& state, double dt) {
    const Outcome outcome = inner(solid, state, dt);
    if (outcome) impose(solid, actions, state, false);
    return outcome;
  };
  return integrator;
}

#define PLUMBLINE_INSTANTIATE(d)                                                \
  template void apply_actions<d>(Solid<d>&, const Actions<d>&);                 \
  template void impose<d>(const Solid<d>&, const Actions<d>&, State<d>&, bool); \
  template ChosenIntegrator<d> with_prescribed_motion<d>(ChosenIntegrator<d>, const Actions<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
