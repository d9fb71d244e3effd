#include "lib/run/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

constexpr std::array<std::string_view, 6> cause_names = {"non-finite",         "inverted",  "energy-growth",
                                                         "time-step-collapse", "hourglass", "no-convergence"};
/// Energy and hourglass share are looked at every so many steps; an explosion multiplies the energy by far
/// more than any bound in between.
constexpr long steps_between_checks = 20;

/// A step and the moment that it is cut to meet, if any [s].
struct NextStep {
  double dt;
  std::optional<double> meets;
  bool last = false;
};

/// Cuts the allowed step at the next multiple of the interval and at the end.
NextStep next_step(const StepControl& control, double time, double allowed) {
  constexpr double rounding = 1e-12;  // what rounding leaves of a moment after a million steps
  NextStep step{allowed, {}};
  if (control.interval) {
    const double next = (std::floor(time / *control.interval * (1 + rounding)) + 1) * *control.interval;
    if (time + allowed >= next * (1 - rounding)) step = {next - time, next};
  }
  if (control.end_time && time + step.dt >= *control.end_time * (1 - rounding))
    step = {*control.end_time - time, *control.end_time, true};
  return step;
}

/// Whether the body has come to rest, where that ends the run.
bool at_rest(const Steps& steps, const StepControl& control, RunResult& result) {
  if (!control.rest || !steps.residual) return false;
  if (const auto residual = steps.residual()) result.residual = residual;
  return result.residual && *result.residual <= *control.rest && steps.now().time >= control.rest_after;
}

/// A run that should have come to rest and did not.
std::optional<Failure> restless(const StepControl& control, const RunResult& result, const Moment& now) {
  if (!control.rest || result.stopped || result.failure) return result.failure;
  if (result.residual && *result.residual <= *control.rest && now.time >= control.rest_after)
    return std::nullopt;
  return Failure{now.time,     now.step,        Cause::no_convergence,
                 std::nullopt, result.residual, "residual over the forces of loads and supports"};
}

bool finished(const Moment& now, const StepControl& control) {
  // 1e-12 of the end time: what rounding leaves of it after a million steps
  if (control.end_time && now.time >= *control.end_time * (1 - 1e-12)) return true;
  return control.max_steps && now.step >= *control.max_steps;
}

}  // namespace

Cause cause_named(std::string_view name) {
  const auto found = std::find(cause_names.begin(), cause_names.end(), name);
  if (found == cause_names.end())
    throw std::invalid_argument("no cause of a failure is called " + std::string(name));
  return static_cast<Cause>(found - cause_names.begin());
}

std::string_view name_of(Cause cause) {
  return cause_names[static_cast<std::size_t>(cause)];
}

void StepStatistics::count(double dt) {
  if (first == 0) first = least = most = dt;
  least = std::min(least, dt);
  most = std::max(most, dt);
  last = dt;
}

RunResult step_to_the_end(const Steps& steps, const StepControl& control,
                          const std::function<bool()>& observe, RunRecord& record) {
  RunResult result;
  result.stopped = observe && !observe();
  while (!result.stopped && !finished(steps.now(), control) && !at_rest(steps, control, result)) {
    const auto [time, step] = steps.now();
    const double allowed = steps.allowed();
    if (!(allowed > control.collapse * record.dt.first)) {
      const Cause cause = std::isfinite(allowed) ? Cause::time_step_collapse : Cause::non_finite;
      result.failure = Failure{time, step, cause, std::nullopt, allowed, "time step"};
      break;
    }
    const NextStep next = next_step(control, time, allowed);
    result.failure = steps.advance(next.dt);
    if (result.failure) break;
    if (next.meets) steps.set_time(*next.meets);
    if (!next.last)
      record.dt.count(allowed);
    else if (record.dt.first == 0)
      record.dt.count(next.dt);
    if (steps.now().step % steps_between_checks == 0) result.failure = steps.out_of_bounds(record);
    if (result.failure) break;
    result.stopped = observe && !observe();
  }
  result.failure = restless(control, result, steps.now());
  result.dt = record.dt;
  return result;
}

}  // namespace plumb
