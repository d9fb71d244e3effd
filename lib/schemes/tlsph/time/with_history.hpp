#pragma once
#include "lib/schemes/tlsph/loops/commit_history.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"

namespace plumb {

/// Returns the integrator as one that commits the history of the body after each step that has been made.
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
