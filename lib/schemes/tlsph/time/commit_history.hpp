#pragma once
#include "lib/schemes/tlsph/loops/body_history.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"

namespace plumb {

/// Moves the history of a body to its displacements, once a step; a body without history stays as it is.
template <int d>
void commit_history(const Solid<d>& solid, const State<d>& state) {
  const auto& history = solid.sweeps.history;
  if (!history) return;
  const Index blocks = solid.blocks();
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
  for (Index b = 0; b < blocks; ++b) history->commit(solid.bonds, state.u, solid.block(b));
}

/// The same integrator, which commits the history of the body after each step that has been made.
template <int d>
ChosenIntegrator<d> with_history(ChosenIntegrator<d> integrator, const Solid<d>& solid) {
  if (!solid.sweeps.history) return integrator;
  integrator.step = [inner = integrator.step](const Solid<d>& body, State<d>& state, double dt) {
    const Outcome outcome = inner(body, state, dt);
    if (outcome) commit_history(body, state);
    return outcome;
  };
  return integrator;
}

}  // namespace plumb
