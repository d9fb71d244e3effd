#pragma once
#include "lib/run/simulation.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/stored_energy.hpp"

namespace plumb {

/// A body that can be asked for its energy, whatever it is made of. Its functions are called once a run and
/// once a step.
template <int d>
struct ImplicitBody {
  std::function<StoredEnergy<d>()> energy;
  std::function<const Actions<d>&()> actions;
  std::function<BodyMotion()> motion;
  std::function<void(const BodyMotion&)> move;
};

/// The body of a simulation with that state, which must live as long.
template <int d, StateOfMotion S>
ImplicitBody<d> implicit_body(const std::shared_ptr<S>& state, const Slots& slots,
                              std::function<StoredEnergy<d>()> energy,
                              std::function<const Actions<d>&()> actions) {
  return {std::move(energy), std::move(actions), [state, slots] { return motion_of<d>(slots, *state); },
          [state, slots](const BodyMotion& motion) { set_motion<d>(slots, motion, *state); }};
}

/// Says for a reader how Newton's method goes from step to step.
Statement said_of(const ImplicitOptions& options);

/// Makes the simulation go as [implicit] of the scene says: from equilibrium to equilibrium, where a step of
/// dt is the way to the loads of dt later, or in time by the midpoint rule. Throws InputError if the scene
/// has no end time, or a velocity that an equilibrium has not.
template <int d>
void go_implicitly(Simulation<d>& simulation, ImplicitBody<d> body, const Scene& scene);

}  // namespace plumb
