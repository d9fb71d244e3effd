#pragma once
#include <limits>
#include <memory>
#include <optional>

#include "lib/run/scheme_budget.hpp"
#include "lib/run/simulation.hpp"
#include "lib/schemes/rest.hpp"

/// What a simulation shows of loads, damping and supports, and how it comes to rest. `moving` holds a scheme and its
/// state: Moving of any_scheme.hpp.
namespace plumb {

/// Whether a scheme says which accelerations its state has without supports.
template <class M>
bool opens(const M& scheme) {
  if constexpr (requires { scheme.opens(); }) return scheme.opens();
  return true;
}

/// Lets the simulation tell the forces of its supports; they are not numbers where the scheme knows none yet.
template <int d, class Moving>
void give_reactions(Simulation<d>& simulation, const std::shared_ptr<Moving>& moving) {
  simulation.reactions = [moving] {
    auto& [scheme, state, places] = *moving;
    const auto open = scheme.open(state, false);
    if (open) return scheme.outside().reactions(state.time, *open, state.v);
    std::vector<BoundaryForce<d>> unknown = scheme.outside().no_reactions();
    for (auto& of : unknown) of.force.setConstant(std::numeric_limits<double>::quiet_NaN());
    return unknown;
  };
}

/// At some steps the forces before and after are compared; the damping of the next ones follows. THEORY (5.11).
template <int d, class Moving>
void look_for_rest(Simulation<d>& simulation, const std::shared_ptr<Moving>& moving) {
  const auto residual = std::make_shared<std::optional<double>>();
  simulation.has_other_work = true;
  simulation.steps.residual = [residual] { return *residual; };
  simulation.steps.advance = [moving, residual, step = simulation.steps.advance](double dt) {
    auto& [scheme, state, places] = *moving;
    residual->reset();
    std::optional<OpenAcceleration> before;
    const Field u = state.u;
    if (looks_after_step(state.step + 1)) before = scheme.open(state, true);
    auto failure = step(dt);
    if (failure || !before) return failure;
    const auto after = scheme.open(state, true);
    if (!after) return failure;  // the next step will say what is wrong
    const RestLook look = look_for_rest<d>(scheme.outside(), *before, u, *after, state.u);
    *residual = look.residual;
    state.outside.rest_rate = 2 * look.frequency;
    return failure;
  };
}

/// Where the body stands, as its budget sees it.
template <int d, class Moving>
Standing<d> standing_of(Moving& moving) {
  auto& [scheme, state, places] = moving;
  Snapshot<d> shown = scheme.snapshot(state);
  const Energy energy = scheme.energy(state);
  return {state.time,         state.step,    std::move(shown.x),
          std::move(shown.v), state.outside, energy.total() - energy.kinetic + energy.dissipated.value_or(0)};
}

/// Lets a simulation keep the budget of its scheme, if it is asked to.
template <int d, class Moving>
void give_budget(Simulation<d>& simulation, const std::shared_ptr<Moving>& moving) {
  const auto budget = std::make_shared<std::optional<SchemeBudget<d>>>();
  simulation.keep_budget = [moving, budget](const std::filesystem::path& file) {
    moving->scheme.outside().follow_changes();
    budget->emplace(file, moving->scheme.outside(), moving->places, standing_of<d>(*moving));
  };
  simulation.close_step = [moving, budget](bool sound) {
    if (sound && *budget) (*budget)->close_step(moving->scheme.outside(), standing_of<d>(*moving));
  };
}

/// What a scheme says of loads, damping and supports that has
///   const OutsideForces<d>& outside() const;                     with their work as state.outside,
///   std::optional<OpenAcceleration> open(state, bool still);     at velocity zero if it is still, and
///   bool opens() const;                                          (optional) false: open() cannot be asked.
template <int d, class Moving>
void give_outside(Simulation<d>& simulation, const std::shared_ptr<Moving>& moving) {
  simulation.external_work = [moving] { return moving->scheme.outside().named(moving->state.outside); };
  give_budget<d>(simulation, moving);
  if (!opens(moving->scheme)) return;
  if (!moving->scheme.outside().no_reactions().empty()) give_reactions<d>(simulation, moving);
  if (simulation.control.rest) look_for_rest<d>(simulation, moving);
}

}  // namespace plumb
