#include "verification/plumb/explain/cost.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <ctime>
#include <type_traits>

#include "lib/scene/tlsph.hpp"
#include "verification/plumb/run/inventory.hpp"
#include "verification/plumb/run/scene_options.hpp"

namespace plumb::app {
namespace {

/// The scene's body cut to at most 1500 particles, or 300 where the set-up solves a system; free and at rest.
Scene sample_of(Scene scene) {
  const double most = scene.method.gradient == "compatible" ? 300 : 1500;
  const long ends = scene.body.layout == Layout::node ? 1 : 0;
  double particles = 0;
  do {
    particles = 1;
    for (const long along : scene.body.particles) particles *= static_cast<double>(along);
    auto& longest = *std::max_element(scene.body.particles.begin(), scene.body.particles.end());
    if (particles > most) --longest;
  } while (particles > most);
  for (std::size_t k = 0; k < scene.body.size.size(); ++k)
    scene.body.size[k] = *scene.body.spacing * static_cast<double>(scene.body.particles[k] - ends);
  scene.boundaries.clear();
  scene.load.reset();
  scene.initial.reset();
  scene.output.reset();
  return scene;
}

/// One thread while it lives: a small body is faster so, and other programs disturb less.
class OneThread {
 public:
  OneThread() { omp_set_num_threads(1); }
  ~OneThread() { omp_set_num_threads(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_ = omp_get_max_threads();
};

/// CPU time of this thread [s]: what other programs do is not in it.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A body that is stepped to see what it costs.
template <int d>
struct Stepped {
  explicit Stepped(const Scene& scene)
      : simulation(make_tlsph<d>(scene)),
        dt(time_step(simulation.solid, simulation.state, simulation.control)),
        bytes(static_cast<double>(total_bytes(arrays_of(simulation))) /
              static_cast<double>(simulation.solid.cloud.size())) {
    simulation.control.end_time.reset();
  }

  /// Time of a step, over a few [s].
  double seconds() {
    constexpr long steps = 8;
    simulation.control.max_steps = simulation.state.step + steps;
    const double start = thread_seconds();
    run<d>(simulation.solid, simulation.state, simulation.integrator, simulation.control);
    return (thread_seconds() - start) / steps;
  }

  TlsphBody<d> simulation;
  double dt, bytes;
};

/// The two take turns, and the least of some rounds counts: what disturbs only adds, and to both.
template <int d>
PartCost compared(std::string part, bool built, Stepped<d>& with, Stepped<d>& without) {
  double time_with = with.seconds(), time_without = without.seconds();
  for (int round = 1; round < 10; ++round) {
    time_with = std::min(time_with, with.seconds());
    time_without = std::min(time_without, without.seconds());
  }
  PartCost cost{std::move(part), built, with.bytes - without.bytes, time_with / time_without, {}};
  if (with.dt < without.dt * (1 - 1e-9)) cost.step_ratio = with.dt / without.dt;
  return cost;
}

template <int d>
Costs costs_of(const Scene& sample) {
  Stepped<d> as_it_is(sample);
  Costs costs{as_it_is.simulation.solid.cloud.size(), {}};
  const auto compare = [&](const std::string& part, bool built, auto&& toggle) {
    Scene scene = sample;
    toggle(scene);
    Stepped<d> other(scene);
    costs.parts.push_back(built ? compared(part, built, as_it_is, other)
                                : compared(part, built, other, as_it_is));
  };
  for_each_part(sample.method, [&]<class Part>(const std::optional<Part>& part) {
    if (std::is_same_v<Part, DampingOptions>) return;  // no memory, and its cost is that of its step
    if (d == 1 && std::is_same_v<Part, ProjectionOptions>) return;  // nothing turns on a line
    compare(fmt::format("{} ({})", Part::subject, Part::section), part.has_value(), [&](Scene& other) {
      for_each_part(other.method, [&]<class Other>(std::optional<Other>& its) {
        if constexpr (std::is_same_v<Other, Part>) its = part ? std::nullopt : std::optional(Part{});
      });
    });
  });
  if (sample.method.time_step) return costs;  // a fixed step asks for no wave speed
  const bool stretches = sample.method.wave_speed != "linear";
  compare("wave speed of the stretch", stretches,
          [&](Scene& other) { other.method.wave_speed = stretches ? "linear" : "stretch"; });
  return costs;
}

}  // namespace

Costs measure_costs(const Scene& scene) {
  const OneThread alone;
  Costs costs{};
  with_dimension(scene, [&]<int d>() {
    costs = costs_of<d>(sample_of(scene));
    return 0;
  });
  return costs;
}

}  // namespace plumb::app
