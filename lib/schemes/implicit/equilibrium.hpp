#pragma once
#include <optional>
#include <vector>

#include "lib/schemes/implicit/load_path.hpp"

namespace plumb {

/// What find_equilibrium() did.
template <int d>
struct StaticResult {
  std::vector<LoadStep> steps;              ///< those that converged
  int rejected = 0;                         ///< steps that were tried again with half their length
  std::vector<BoundaryForce<d>> reactions;  ///< at the last equilibrium
  std::optional<StaticFailure> failure;     ///< nullopt: the end of the path was reached
  bool completed() const { return !failure; }
};

/// Finds the equilibrium of a body under the loads and supports of the end time [s], by a LoadPath from the
/// state's time (0: no load) on. The state is left at the last equilibrium, at rest, so that a path that
/// could not be ended can be resumed. Throws InputError as LoadPath does.
template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep& on_step = {});
/// Finds the equilibrium of whatever has an energy.
template <int d>
StaticResult<d> find_equilibrium(StoredEnergy<d> energy, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, BodyMotion& motion,
                                 const OnLoadStep& on_step = {});

}  // namespace plumb
