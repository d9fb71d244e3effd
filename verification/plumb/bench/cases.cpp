#include "plumb/bench/cases.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "plumb/run/inventory.hpp"
#include "plumbline/scene/simulation.hpp"

namespace plumb::bench {
namespace {

struct Clock {
  std::clock_t cpu = std::clock();
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  double cpu_s() const { return static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC; }
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  }
};

Scene body(int dimension, bool paper, double jitter) {
  Scene scene;
  scene.dimension = dimension;
  scene.body.size.assign(dimension, 1.0);
  scene.body.jitter = jitter;
  scene.material = {"neo-hookean", 1e7, 0.3, 1000};
  if (paper) {
    scene.method.momentum = "symmetrised";
    scene.method.integrator = "rk3";
    scene.jst = Jst{};
  }
  Boundary clamp;  // so that boundaries cost what they cost
  clamp.face = Face{0, -1};
  scene.boundaries = {clamp};
  return scene;
}

/// A smooth motion of the free faces, so that no step sees a body at rest.
template <int d>
void set_in_motion(Simulation<d>& simulation) {
  for (Index i = 0; i < simulation.solid.cloud.size(); ++i) {
    const Vec<d>& X = simulation.solid.cloud.X[i];
    Vec<d> v = Vec<d>::Zero();
    v[d - 1] = 0.5 * X[0] * X[0];
    set_vector<d>(simulation.state.v, simulation.solid.bonds.slots.of(i), v);
  }
}

template <int d>
Speed measure_in(const Case& c, long particles, int threads, int repeats, double seconds) {
  Scene scene = c.scene;
  const long cells = std::max(2L, std::lround(std::pow(static_cast<double>(particles), 1.0 / d)) - 1);
  scene.max_steps = 1;
  scene.body = with_spacing(scene.body, 1.0 / static_cast<double>(cells));
  omp_set_num_threads(threads);
  const Clock setup;
  Simulation<d> simulation = make_simulation<d>(scene);
  Speed speed;
  speed.setup_cpu_s = setup.cpu_s();
  set_in_motion(simulation);
  Solid<d>& solid = simulation.solid;
  speed.particles = solid.cloud.size();
  speed.threads = threads;
  speed.bytes_per_particle =
      static_cast<double>(total_bytes(arrays_of(simulation))) / static_cast<double>(speed.particles);
  const double pairs = static_cast<double>(solid.bonds.pairs) / static_cast<double>(speed.particles);
  speed.flops_per_update = pairs * (d + 4.0 * d * d);
  long steps = 2;
  for (int n = 0; n <= repeats; ++n) {  // the first one warms up and says how many steps to take
    const std::int64_t before = solid.work.particle_evaluations;
    simulation.control.max_steps = simulation.state.step + steps;
    const Clock clock;
    run(solid, simulation.state, simulation.stepper, simulation.control);
    const double cpu = clock.cpu_s(), wall = clock.wall_s();
    const auto updates = static_cast<double>(solid.work.particle_evaluations - before);
    if (n == 0) {
      steps = std::clamp(std::lround(static_cast<double>(steps) * seconds / std::max(cpu, 1e-6)), 2L, 20000L);
      continue;
    }
    speed.updates_per_cpu_s = std::max(speed.updates_per_cpu_s, updates / cpu);
    speed.updates_per_wall_s = std::max(speed.updates_per_wall_s, updates / wall);
  }
  return speed;
}

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {{"adjoint-verlet-3d", body(3, false, 0)},
                                        {"paper-3d", body(3, true, 0)},
                                        {"adjoint-verlet-3d-jittered", body(3, false, 0.2)},
                                        {"adjoint-verlet-2d", body(2, false, 0)},
                                        {"paper-2d", body(2, true, 0)},
                                        {"adjoint-verlet-2d-jittered", body(2, false, 0.2)}};
  return all;
}

Speed measure(const Case& c, long particles, int threads, int repeats, double seconds) {
  return c.scene.dimension == 2 ? measure_in<2>(c, particles, threads, repeats, seconds)
                                : measure_in<3>(c, particles, threads, repeats, seconds);
}

}  // namespace plumb::bench
