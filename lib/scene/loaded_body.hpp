#pragma once
#include "lib/run/saved_state.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/implicit/balance.hpp"
#include "lib/schemes/implicit/body_motion.hpp"

namespace plumb {

/// The body of a scene in a state that a run has saved, with all that its balance needs.
template <int d>
struct LoadedBody {
  StoredEnergy<d> energy;
  Actions<d> actions;
  BodyMotion motion;
  PathPoint at;  ///< how far the loads have grown there

  Balance<d> balance() const { return {energy, actions, at, motion.u}; }
};

/// Puts the body of the scene where the saved state has it. InputError if the state does not fit, or the
/// scheme keeps no energy of displacements ("mixed").
template <int d>
LoadedBody<d> loaded_body(const Scene& scene, const SavedState& saved);

}  // namespace plumb
