#include "plumbline/solid/run.hpp"

#include <array>
#include <cmath>

#include "plumbline/diagnostics/measures.hpp"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 5> cause_names = {"non-finite", "inverted", "energy-growth",
                                                         "time-step-collapse", "hourglass"};
/// The energy is looked at every so many steps; an explosion multiplies it by far more than any bound in
/// between.
constexpr long steps_between_energy_checks = 20;

Failure unsound(const UnsoundParticle& found, double time, long step) {
  const bool finite = std::isfinite(found.determinant);
  return {time,       step, finite ? Cause::inverted : Cause::non_finite, found.particle, found.determinant,
          "J = det F"};
}

template <int d>
bool finished(const State<d>& state, const StepControl& control) {
  // 1e-12 of the end time: what rounding leaves of it after a million steps
  if (control.end_time && state.time >= *control.end_time * (1 - 1e-12)) return true;
  return control.max_steps && state.step >= *control.max_steps;
}

}  // namespace

std::string_view name_of(Cause cause) {
  return cause_names[static_cast<std::size_t>(cause)];
}

void StepStatistics::count(double dt) {
  if (first == 0) first = least = most = dt;
  least = std::min(least, dt);
  most = std::max(most, dt);
  last = dt;
}

template <int d>
double time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control) {
  if (control.fixed_step) return *control.fixed_step;
  return std::min(control.cfl * crossing_time(solid, state, control.wave_speed), solid.step_limit);
}

template <int d>
RunResult run(Solid<d>& solid, State<d>& state, const Stepper<d>& stepper, const StepControl& control,
              const Observer<d>& observe) {
  RunResult result;
  const double energy_limit =
      control.energy_bound ? (1 + *control.energy_bound) * energy_of(solid, state).total() : 0;
  result.stopped = observe && !observe(solid, state);
  while (!result.stopped && !finished(state, control)) {
    double dt = time_step(solid, state, control);
    if (!(dt > control.collapse * result.dt.first)) {
      const Cause cause = std::isfinite(dt) ? Cause::time_step_collapse : Cause::non_finite;
      result.failure = Failure{state.time, state.step, cause, -1, dt, "time step"};
      break;
    }
    const bool last = control.end_time && state.time + dt >= *control.end_time;
    if (last) dt = *control.end_time - state.time;
    if (!stepper.step(solid, state, dt)) {
      result.failure = unsound(solid.unsound, state.time, state.step);
      break;
    }
    if (!last || result.dt.first == 0) result.dt.count(dt);  // the cut step says nothing about stability
    if (control.energy_bound && state.step % steps_between_energy_checks == 0) {
      const double energy = energy_of(solid, state).total();
      if (!(energy <= energy_limit)) {
        result.failure = Failure{state.time, state.step, Cause::energy_growth, -1, energy, "total energy"};
        break;
      }
    }
    result.stopped = observe && !observe(solid, state);
  }
  return result;
}

template double time_step<2>(const Solid<2>&, const State<2>&, const StepControl&);
template double time_step<3>(const Solid<3>&, const State<3>&, const StepControl&);
template RunResult run<2>(Solid<2>&, State<2>&, const Stepper<2>&, const StepControl&, const Observer<2>&);
template RunResult run<3>(Solid<3>&, State<3>&, const Stepper<3>&, const StepControl&, const Observer<3>&);

}  // namespace plumb
