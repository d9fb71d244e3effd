#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/run/run_record.hpp"
#include "lib/run/saved_state.hpp"
#include "lib/schemes/default_cfl.hpp"
#include "lib/schemes/wave_speed.hpp"

namespace plumb {

/// How far and with which time steps.
struct StepControl {
  double cfl = default_cfl;          ///< alpha_CFL of paper 000 (31); other schemes have a cfl of their own
  std::optional<double> fixed_step;  ///< [s]; instead of cfl
  WaveSpeed wave_speed = WaveSpeed::linear;
  std::optional<double> end_time;  ///< [s]; the last step is cut to meet it
  std::optional<double> interval;  ///< [s]; steps are cut so that a state falls on each of its multiples
  std::optional<long> max_steps;
  /// Ends the run when Steps::residual is not above this; a failure if the end comes first.
  std::optional<double> rest;
  double rest_after = 0;               ///< [s]: not before loads have grown to their values
  std::optional<double> energy_bound;  ///< unstable if the total energy exceeds (1 + bound) times the initial
                                       ///< one by more than round-off
  /// A step below this share of the first one counts as collapsed: a body whose spacing shrinks a
  /// thousandfold somewhere has lost its particles' order there, and would not end in reasonable time.
  double collapse = 1e-3;
  /// Unstable if the hourglass share (THEORY (8.4)) exceeds this; looked at as often as the energy.
  std::optional<double> hourglass_bound;
};

/// Tells why a run ended early.
enum class Cause { non_finite, inverted, energy_growth, time_step_collapse, hourglass, no_convergence };
std::string_view name_of(Cause cause);
/// Returns the cause of that name; std::invalid_argument if there is none.
Cause cause_named(std::string_view name);

/// Describes the end of a run that could not go on.
struct Failure {
  double time;  ///< [s]
  long step;
  Cause cause;
  std::optional<Index> particle;  ///< where it was found; nothing if it belongs to no particle
  std::optional<double>
      value;  ///< of the quantity: J, energy ratio, time step [s]; nothing if none was found
  std::string quantity;
};

/// Holds what a run came to.
struct RunResult {
  std::optional<Failure> failure;
  bool stopped = false;            ///< by the observer
  std::optional<double> residual;  ///< the last one, of a run that looks for rest
  StepStatistics dt;
  bool completed() const { return !failure && !stopped; }
};

/// What the loop over time steps asks of a body, whatever its scheme.
struct Steps {
  std::function<Moment()> now;
  std::function<void(double)> set_time;  ///< to the moment that a step was cut to meet [s], without rounding
  std::function<double()> allowed;       ///< the step that the control allows now [s]
  /// Steps by dt [s]. After a failure the state is the one before the step.
  std::function<std::optional<Failure>(double dt)> advance;
  /// Compares the body as a whole with the bounds of the control; asked every so many steps.
  std::function<std::optional<Failure>(const RunRecord&)> out_of_bounds;
  /// Unbalanced forces relative to those of loads and supports; nullopt: not looked at after this step.
  /// Empty: the body does not look for rest.
  std::function<std::optional<double>()> residual = {};
};

/// Steps until the end, a failure, or until `observe` returns false. It is called at the start and after
/// every step; empty: nobody looks. The record's initial energy is there if a bound needs it.
RunResult step_to_the_end(const Steps& steps, const StepControl& control,
                          const std::function<bool()>& observe, RunRecord& record);

}  // namespace plumb
