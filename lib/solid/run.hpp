#pragma once
#include <functional>
#include <optional>
#include <string_view>

#include "plumbline/time/integrator.hpp"
#include "plumbline/time/time_step.hpp"

namespace plumb {

/// How far and with which time steps.
struct StepControl {
  double cfl = 0.9;                  ///< alpha_CFL of (31)
  std::optional<double> fixed_step;  ///< [s]; instead of cfl
  WaveSpeed wave_speed = WaveSpeed::linear;
  std::optional<double> end_time;  ///< [s]; the last step is cut to meet it
  std::optional<long> max_steps;
  std::optional<double>
      energy_bound;  ///< unstable if the total energy exceeds (1 + bound) times the initial one
  /// A step below this share of the first one counts as collapsed: a body whose spacing shrinks a
  /// thousandfold somewhere has lost its particles' order there, and would not end in reasonable time.
  double collapse = 1e-3;
  /// Unstable if the hourglass share (THEORY (8.4)) exceeds this; looked at as often as the energy.
  std::optional<double> hourglass_bound;
};

enum class Cause { non_finite, inverted, energy_growth, time_step_collapse, hourglass };
std::string_view name_of(Cause cause);

struct Failure {
  double time;  ///< [s]
  long step;
  Cause cause;
  Index particle;  ///< where it was found; -1 if it belongs to no particle
  double value;    ///< of the quantity: J, energy ratio, time step [s]
  std::string_view quantity;
};

struct StepStatistics {
  double first = 0, least = 0, most = 0, last = 0;  ///< [s]
  void count(double dt);
};

struct RunResult {
  std::optional<Failure> failure;
  bool stopped = false;  ///< by the observer
  StepStatistics dt;
  bool completed() const { return !failure && !stopped; }
};

/// What a continued run has behind it: its bounds refer to the first state, not to the one it continues from.
struct RunSoFar {
  StepStatistics dt;
  double initial_energy;  ///< total [J]
};

/// Called at the start and after every step; false stops the run.
template <int d>
using Observer = std::function<bool(const Solid<d>&, const State<d>&)>;

/// The time step that the control allows in this state [s], not yet cut at the end time.
template <int d>
double time_step(const Solid<d>& solid, const State<d>& state, const StepControl& control);

/// Steps until the end. On failure the state is the last good one.
template <int d>
RunResult run(Solid<d>& solid, State<d>& state, const Stepper<d>& stepper, const StepControl& control,
              const Observer<d>& observe = {}, const std::optional<RunSoFar>& so_far = {});

}  // namespace plumb
