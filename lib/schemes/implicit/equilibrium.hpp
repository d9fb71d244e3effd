#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/schemes/implicit/implicit_options.hpp"
#include "plumbline/schemes/implicit/newton.hpp"

namespace plumb {

/// One load step that ended in equilibrium.
struct LoadStep {
  double share;  ///< of the path, at its end
  NewtonResult newton;
};

/// Why the end of the path was not reached.
struct StaticFailure {
  std::string cause;              ///< "inverted", "non-finite", "stalled" or "limit-point"
  double share;                   ///< of the path that could not be reached from the one before
  UnsoundParticle particle;       ///< with J <= 0, if that is the cause
  std::vector<double> residuals;  ///< of the last search
  /// Says it in a sentence.
  std::string in_words() const;
};

/// The force of the supports of one boundary on the body [N] (per metre of thickness in 2D).
template <int d>
struct Reaction {
  std::string boundary;
  Vec<d> force;
};

/// What find_equilibrium() did.
template <int d>
struct StaticResult {
  std::vector<LoadStep> steps;           ///< those that converged
  int rejected = 0;                      ///< steps that were tried again with half their length
  std::vector<Reaction<d>> reactions;    ///< at the last equilibrium
  std::optional<StaticFailure> failure;  ///< nullopt: the end of the path was reached
  bool completed() const { return !failure; }
};

/// Called at every equilibrium on the way; the state has its displacements and its time.
template <int d>
using OnLoadStep = std::function<void(const State<d>& state, const LoadStep& step)>;

/// Finds the equilibria of a body on the way to the loads and supports of the end time [s], from the state at
/// its time (0: no load) on. Loads and displacements that vary in time are taken at the time of the step;
/// constant ones grow in proportion to it. The state is left at the last equilibrium, at rest, so that a path
/// that could not be ended can be resumed. Dead loads and pressures that follow; any elastic law, any bond
/// table with the adjoint force, terms with an energy. Throws InputError if the body can move freely, or if
/// its force has no energy.
template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep<d>& on_step = {});

}  // namespace plumb
