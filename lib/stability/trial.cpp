#include "plumbline/stability/trial.hpp"

#include <ctime>

#include "plumbline/diagnostics/measures.hpp"
#include "plumbline/scene/simulation.hpp"

namespace plumb {
namespace {

/// CPU time of this thread [s]: other runs go on beside it.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <int d>
double stretch_of(const Extent<d>& before, const Extent<d>& now) {
  return ((now.upper - now.lower).array() / (before.upper - before.lower).array()).maxCoeff();
}

template <int d>
std::optional<Trial> attempt(const Scene& scene, const StabilityBounds& bounds,
                             const std::function<bool()>& go_on) {
  const double start = thread_seconds();
  Simulation<d> simulation = make_simulation<d>(scene);
  simulation.control.energy_bound = bounds.energy_growth;
  simulation.control.hourglass_bound = bounds.hourglass;
  const Extent<d> before = extent_of(simulation.solid, simulation.state);
  const double energy = energy_of(simulation.solid, simulation.state).total();
  const RunResult result = run<d>(simulation.solid, simulation.state, simulation.stepper, simulation.control,
                                  [&](const Solid<d>&, const State<d>&) { return go_on(); });
  if (result.stopped) return std::nullopt;
  Trial trial;
  if (result.failure) trial.cause = result.failure->cause;
  trial.time = simulation.state.time;
  trial.steps = simulation.state.step;
  trial.stretch = stretch_of(before, extent_of(simulation.solid, simulation.state));
  trial.hourglass = hourglass_share(simulation.solid, simulation.state);
  trial.energy = energy > 0 ? energy_of(simulation.solid, simulation.state).total() / energy : 0;
  trial.cpu = thread_seconds() - start;
  return trial;
}

}  // namespace

std::optional<Trial> try_scene(const Scene& scene, const StabilityBounds& bounds,
                               const std::function<bool()>& go_on) {
  try {
    return scene.dimension == 2 ? attempt<2>(scene, bounds, go_on) : attempt<3>(scene, bounds, go_on);
  } catch (const InputError& error) {
    Trial trial;
    trial.refused = error.problem() + (error.why().empty() ? "" : " (" + error.why() + ")");
    return trial;
  }
}

}  // namespace plumb
