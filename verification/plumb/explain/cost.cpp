#include "plumb/explain/cost.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <type_traits>

#include "plumb/run/inventory.hpp"
#include "plumb/run/scene_options.hpp"
#include "plumbline/scene/simulation.hpp"

namespace plumb {
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

struct Measured {
  double bytes, seconds, dt;
  long particles;
};

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

/// Bytes a particle, and the time of a step: the least of some rounds, since other programs only add to it.
template <int d>
Measured measured(const Scene& scene) {
  using Clock = std::chrono::steady_clock;
  Simulation<d> simulation = make_simulation<d>(scene);
  StepControl control = simulation.control;
  const double dt = time_step(simulation.solid, simulation.state, control);
  control.end_time.reset();
  double seconds = 0;
  constexpr int rounds = 5;
  constexpr long steps = 8;
  for (int round = 0; round < rounds; ++round) {
    control.max_steps = simulation.state.step + steps;
    const auto start = Clock::now();
    run<d>(simulation.solid, simulation.state, simulation.stepper, control);
    const double taken = std::chrono::duration<double>(Clock::now() - start).count() / steps;
    if (round == 0 || taken < seconds) seconds = taken;
  }
  const Index particles = simulation.solid.cloud.size();
  return {static_cast<double>(total_bytes(arrays_of(simulation))) / static_cast<double>(particles), seconds,
          dt, particles};
}

Measured measured(const Scene& scene) {
  Measured result{};
  with_dimension(scene, [&]<int d>() {
    result = measured<d>(scene);
    return 0;
  });
  return result;
}

PartCost compared(std::string part, bool built, const Measured& with, const Measured& without) {
  PartCost cost{std::move(part), built, with.bytes - without.bytes, with.seconds / without.seconds, {}};
  if (with.dt < without.dt * (1 - 1e-9)) cost.step_ratio = with.dt / without.dt;
  return cost;
}

}  // namespace

Costs measure_costs(const Scene& scene) {
  const OneThread alone;
  const Scene sample = sample_of(scene);
  const Measured as_it_is = measured(sample);
  Costs costs{as_it_is.particles, {}};
  const auto compare = [&](const std::string& part, bool built, auto&& toggle) {
    Scene other = sample;
    toggle(other);
    const Measured changed = measured(other);
    costs.parts.push_back(compared(part, built, built ? as_it_is : changed, built ? changed : as_it_is));
  };
  for_each_part(scene.method, [&]<class Part>(const std::optional<Part>& part) {
    if (std::is_same_v<Part, DampingOptions>) return;  // no memory, and its cost is that of its step
    compare(fmt::format("{} ({})", Part::subject, Part::section), part.has_value(), [&](Scene& other) {
      for_each_part(other.method, [&]<class Other>(std::optional<Other>& its) {
        if constexpr (std::is_same_v<Other, Part>) its = part ? std::nullopt : std::optional(Part{});
      });
    });
  });
  if (scene.method.time_step) return costs;  // a fixed step asks for no wave speed
  const bool stretches = scene.method.wave_speed != "linear";
  compare("wave speed of the stretch", stretches,
          [&](Scene& other) { other.method.wave_speed = stretches ? "linear" : "stretch"; });
  return costs;
}

}  // namespace plumb
