#pragma once
#include "lib/run/run.hpp"
#include "lib/schemes/tlsph/time/closest_pairs.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"
#include "lib/schemes/tlsph/time/time_step.hpp"

namespace plumb {

/// Called at the start and after every step; false stops the run.
template <int d>
using Observer = std::function<bool(const Solid<d>&, const State<d>&)>;

/// The time step that the control allows in this state [s], not yet cut at the end time.
template <int d>
double time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control);

/// Whether the step follows from the closest pairs: they are then kept from step to step.
bool follows_closest_pairs(const StepControl& control);

/// Returns the time step that the control allows [s], following the closest pairs from step to step.
template <int d>
double next_time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control,
                      ClosestPairs<d>& closest);

/// The steps of a total Lagrangian body. All of its arguments must outlive them; run() below and as_simulation() keep them.
template <int d>
Steps steps_of(const Solid<d>& solid, State<d>& state, const ChosenIntegrator<d>& integrator,
               const StepControl& control, ClosestPairs<d>& closest);

/// Steps until the end. On failure the state is the last good one.
template <int d>
RunResult run(const Solid<d>& solid, State<d>& state, const ChosenIntegrator<d>& integrator,
              const StepControl& control, const Observer<d>& observe, RunRecord& record);

/// Runs from the state as it is, as a run that begins here.
template <int d>
RunResult run(const Solid<d>& solid, State<d>& state, const ChosenIntegrator<d>& integrator,
              const StepControl& control, const Observer<d>& observe = {}) {
  RunRecord none;
  return run(solid, state, integrator, control, observe, none);
}

}  // namespace plumb
