#include "lib/schemes/tlsph/run/solid_run.hpp"

#include <cmath>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb {
namespace {

Failure failure_of(const Trouble& found, double time, long step) {
  const bool finite = std::isfinite(found.value);
  return {time,           step,        finite ? Cause::inverted : Cause::non_finite,
          found.particle, found.value, found.quantity};
}

/// Whether the body as a whole has left its bounds.
template <int d>
std::optional<Failure> out_of_bounds(const Solid<d>& solid, const State<d>& state, const StepControl& control,
                                     const RunRecord& record) {
  if (control.energy_bound) {
    const double energy = energy_of(solid, state).total();
    const double round_off = 2 * energy_round_off(solid);  // of this energy and of the initial one
    if (!(energy <= (1 + *control.energy_bound) * *record.initial_energy + round_off))
      return Failure{state.time, state.step, Cause::energy_growth, std::nullopt, energy, "total energy"};
  }
  if (control.hourglass_bound) {
    const double share = hourglass_share(solid, state);
    if (!(share <= *control.hourglass_bound))
      return Failure{state.time, state.step, Cause::hourglass, std::nullopt, share, "hourglass share"};
  }
  return std::nullopt;
}

template <int d>
double step_for(const Solid<d>& solid, const StepControl& control, double crossing) {
  return std::min(control.cfl * crossing, solid.step_limit);
}

}  // namespace

template <int d>
double time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control) {
  if (control.fixed_step) return *control.fixed_step;
  return step_for(solid, control, crossing_time(solid, state, control.wave_speed));
}

bool follows_closest_pairs(const StepControl& control) {
  return !control.fixed_step && control.wave_speed == WaveSpeed::linear;
}

template <int d>
double next_time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control,
                      ClosestPairs<d>& closest) {
  if (!follows_closest_pairs(control)) return time_step(solid, state, control);
  return step_for(solid, control, closest.distance(solid, state) / solid.elastic.wave_speed());
}

template <int d>
RunResult run(const Solid<d>& solid, State<d>& state, const ChosenIntegrator<d>& integrator,
              const StepControl& control, const Observer<d>& observe, RunRecord& record) {
  if (control.energy_bound && !record.initial_energy) record.initial_energy = energy_of(solid, state).total();
  ClosestPairs<d> closest;
  const Steps steps = steps_of(solid, state, integrator, control, closest);
  const auto look = [&] { return !observe || observe(solid, state); };
  return step_to_the_end(steps, control, look, record);
}

template <int d>
Steps steps_of(const Solid<d>& solid, State<d>& state, const ChosenIntegrator<d>& integrator,
               const StepControl& control, ClosestPairs<d>& closest) {
  return {[&] {
            return Moment{state.time, state.step};
          },
          [&](double time) { state.time = time; },
          [&] { return next_time_step(solid, state, control, closest); },
          [&](double dt) -> std::optional<Failure> {
            const Outcome outcome = integrator.step(solid, state, dt);
            if (outcome) return std::nullopt;
            return failure_of(*outcome.trouble, state.time, state.step);
          },
          [&](const RunRecord& record) { return out_of_bounds(solid, state, control, record); }};
}

template double time_step<1>(const Solid<1>&, const State<1>&, const StepControl&);
template double time_step<2>(const Solid<2>&, const State<2>&, const StepControl&);
template double time_step<3>(const Solid<3>&, const State<3>&, const StepControl&);
template double next_time_step<1>(const Solid<1>&, const State<1>&, const StepControl&, ClosestPairs<1>&);
template double next_time_step<2>(const Solid<2>&, const State<2>&, const StepControl&, ClosestPairs<2>&);
template double next_time_step<3>(const Solid<3>&, const State<3>&, const StepControl&, ClosestPairs<3>&);
template RunResult run<1>(const Solid<1>&, State<1>&, const ChosenIntegrator<1>&, const StepControl&,
                          const Observer<1>&, RunRecord&);
template RunResult run<2>(const Solid<2>&, State<2>&, const ChosenIntegrator<2>&, const StepControl&,
                          const Observer<2>&, RunRecord&);
template RunResult run<3>(const Solid<3>&, State<3>&, const ChosenIntegrator<3>&, const StepControl&,
                          const Observer<3>&, RunRecord&);

template Steps steps_of<1>(const Solid<1>&, State<1>&, const ChosenIntegrator<1>&, const StepControl&,
                           ClosestPairs<1>&);
template Steps steps_of<2>(const Solid<2>&, State<2>&, const ChosenIntegrator<2>&, const StepControl&,
                           ClosestPairs<2>&);
template Steps steps_of<3>(const Solid<3>&, State<3>&, const ChosenIntegrator<3>&, const StepControl&,
                           ClosestPairs<3>&);

}  // namespace plumb
