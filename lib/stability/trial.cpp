#include "lib/stability/trial.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>

#include "lib/core/dimension.hpp"
#include "lib/core/sentences.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb {
namespace {

/// CPU time of this thread [s]: other runs go on beside it.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The particles that say how far the body is stretched. Where it is pulled these are the ones that supports
/// hold and move: a particle that flies off is no stretch. Otherwise all.
template <int d>
std::vector<Index> measured_particles(const TlsphBody<d>& simulation) {
  std::vector<Index> particles;
  bool pulled = false;
  for (const auto& support : simulation.supports) {
    pulled = pulled || support.velocity != 0;
    particles.push_back(support.particle);
  }
  if (pulled) return particles;
  particles.resize(simulation.solid.cloud.size());
  std::iota(particles.begin(), particles.end(), Index{0});
  return particles;
}

/// Edges of the box around them [m].
template <int d>
Vec<d> edges_of(const TlsphBody<d>& simulation, const std::vector<Index>& particles) {
  Vec<d> lower = position_of(simulation.solid, simulation.state, particles.front()), upper = lower;
  for (const Index i : particles) {
    const Vec<d> x = position_of(simulation.solid, simulation.state, i);
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  return upper - lower;
}

template <int d>
double stretch_of(const Vec<d>& before, const Vec<d>& now) {
  double most = 1;
  bool first = true;
  for (int k = 0; k < d; ++k) {
    if (before[k] == 0) continue;  // they lie in a plane
    most = first ? now[k] / before[k] : std::max(most, now[k] / before[k]);
    first = false;
  }
  return most;
}

template <int d>
std::optional<Trial> attempt(const Scene& scene, const StabilityBounds& bounds,
                             const std::function<bool()>& go_on) {
  const double start = thread_seconds();
  TlsphBody<d> simulation = make_tlsph<d>(scene);
  simulation.control.energy_bound = bounds.energy_growth;
  simulation.control.hourglass_bound = bounds.hourglass;
  simulation.control.interval.reset();  // nothing is recorded, so that no step is cut for it
  const std::vector<Index> measured = measured_particles(simulation);
  const Vec<d> before = edges_of(simulation, measured);
  const double energy = energy_of(simulation.solid, simulation.state).total();
  const RunResult result =
      run<d>(simulation.solid, simulation.state, simulation.integrator, simulation.control,
             [&](const Solid<d>&, const State<d>&) { return go_on(); });
  if (result.stopped) return std::nullopt;
  Trial trial;
  if (result.failure) trial.cause = result.failure->cause;
  trial.time = simulation.state.time;
  trial.steps = simulation.state.step;
  trial.stretch = stretch_of<d>(before, edges_of(simulation, measured));
  trial.hourglass = hourglass_share(simulation.solid, simulation.state);
  trial.energy = energy > 0 ? energy_of(simulation.solid, simulation.state).total() / energy : 0;
  trial.cpu = thread_seconds() - start;
  return trial;
}

}  // namespace

std::optional<Trial> try_scene(const Scene& scene, const StabilityBounds& bounds,
                               const std::function<bool()>& go_on) {
  try {
    return with_dimension(scene.dimension, [&]<int d>() { return attempt<d>(scene, bounds, go_on); });
  } catch (const InputError& error) {
    Trial trial;
    trial.refused = sentences(error.problem(), error.why(), "");
    return trial;
  }
}

}  // namespace plumb
