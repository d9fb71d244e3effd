#include "verification/plumb/bench/cases.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/run/traffic.hpp"
#include "verification/plumb/run/inventory.hpp"

namespace plumb::app::bench {
namespace {

struct Clock {
  std::clock_t cpu = std::clock();
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  double cpu_s() const { return static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC; }
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  }
};

/// The schemes, as changes of a scene whose [method] is adjoint, improved, Verlet.
struct Scheme {
  std::string_view name;
  bool main;
  void (*set)(Scene&);
};
constexpr std::array<Scheme, 7> schemes = {{
    {"adjoint-verlet", true, [](Scene&) {}},
    {"paper", true,
     [](Scene& scene) {
       scene.method.momentum = "symmetrised";
       scene.method.integrator = "rk3";
       scene.method.jst = JstOptions{};
     }},
    {"adjoint-rk3", false, [](Scene& scene) { scene.method.integrator = "rk3"; }},
    {"adjoint-verlet-jst", false, [](Scene& scene) { scene.method.jst = JstOptions{}; }},
    {"symmetrised-verlet", false, [](Scene& scene) { scene.method.momentum = "symmetrised"; }},
    {"standard-verlet", false, [](Scene& scene) { scene.method.gradient = "standard"; }},
    {"compatible-verlet", false, [](Scene& scene) { scene.method.gradient = "compatible"; }},
}};
/// A row per particle takes 7 GB at 10^6 while it is set up.
constexpr long most_jittered = 1000000;
/// Set-up of compatible bonds on jittered clouds: factors in 2D, whose work grows faster than N; iterations
/// in 3D, half a minute at 10^5. Lattices have a closed form.
constexpr long most_compatible_factorised = 10000, most_compatible_iterated = 100000;

Case case_of(const Scheme& scheme, int dimension, bool jittered) {
  Case c;
  c.name = std::string(scheme.name) + (dimension == 2 ? "-2d" : "-3d") + (jittered ? "-jittered" : "");
  c.main = scheme.main && !(jittered && scheme.name == "paper");
  Scene& scene = c.scene;
  scene.dimension = dimension;
  scene.method.gradient = "improved";
  scene.body.size.assign(dimension, 1.0);
  scene.body.jitter = jittered ? 0.2 : 0;
  scene.material = {"neo-hookean", 1e7, 0.3, 1000};
  scheme.set(scene);
  if (jittered) c.most = most_jittered;
  if (jittered && scene.method.gradient == "compatible")
    c.most = dimension == 2 ? most_compatible_factorised : most_compatible_iterated;
  Boundary clamp;  // so that boundaries cost what they cost
  clamp.face = Face{0, -1};
  scene.boundaries = {clamp};
  return c;
}

/// A smooth motion of the free faces, so that no step sees a body at rest.
template <int d>
void set_in_motion(TlsphBody<d>& simulation) {
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
  TlsphBody<d> simulation = make_tlsph<d>(scene);
  Speed speed;
  speed.setup_cpu_s = setup.cpu_s();
  speed.setup_wall_s = setup.wall_s();
  set_in_motion(simulation);
  const Solid<d>& solid = simulation.solid;
  const Work& work = simulation.integrator.workspace->work;
  speed.particles = solid.cloud.size();
  speed.threads = threads;
  speed.bytes_per_particle =
      static_cast<double>(total_bytes(arrays_of(simulation))) / static_cast<double>(speed.particles);
  speed.bytes_per_update = bytes_per_update(solid, simulation.integrator);
  const double pairs = static_cast<double>(solid.bonds.pairs) / static_cast<double>(speed.particles);
  speed.flops_per_update = pairs * (d + 4.0 * d * d);
  long steps = 2;
  for (int n = 0; n <= repeats; ++n) {  // the first one warms up and says how many steps to take
    const std::int64_t before = work.particle_evaluations;
    simulation.control.max_steps = simulation.state.step + steps;
    const Clock clock;
    run(solid, simulation.state, simulation.integrator, simulation.control);
    const double cpu = clock.cpu_s(), wall = clock.wall_s();
    const auto updates = static_cast<double>(work.particle_evaluations - before);
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
  static const std::vector<Case> all = [] {
    std::vector<Case> made;
    for (const int dimension : {3, 2})
      for (const bool jittered : {false, true})
        for (const auto& scheme : schemes) made.push_back(case_of(scheme, dimension, jittered));
    return made;
  }();
  return all;
}

Speed measure(const Case& c, long particles, int threads, int repeats, double seconds) {
  return c.scene.dimension == 2 ? measure_in<2>(c, particles, threads, repeats, seconds)
                                : measure_in<3>(c, particles, threads, repeats, seconds);
}

}  // namespace plumb::app::bench
