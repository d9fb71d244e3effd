#include "verification/plumb/bench/kernels.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <memory>

#include "lib/material/models/neo_hookean.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb::app::bench {
namespace {

constexpr double jitter = 0.2;

Scene block(long particles, bool irregular) {
  Scene scene;
  scene.dimension = 3;
  scene.max_steps = 1;
  scene.body.size = {1.0, 1.0, 1.0};
  scene.body.jitter = irregular ? jitter : 0;
  const long cells = std::max(2L, std::lround(std::cbrt(static_cast<double>(particles))) - 1);
  scene.body = with_spacing(scene.body, 1.0 / static_cast<double>(cells));
  scene.material = {"neo-hookean", 1e7, 0.3, 1000};
  scene.method.gradient = "improved";
  scene.method.jst = JstOptions{};
  return scene;
}

/// A deformed body with all that the kernels need.
struct Body {
  TlsphBody<3> simulation;
  Cloud<3> cloud;  ///< another copy: setting up a table may change it
  BondOptions<3> options;

  explicit Body(const Scene& scene)
      : simulation(make_tlsph<3>(scene)),
        cloud(make_cloud<3>(scene.body)),
        options(bond_options<3>(scene, cloud.spacing)) {
    for (Index i = 0; i < cloud.size(); ++i) {
      const Vec<3>& X = cloud.X[i];
      const Index slot = simulation.solid.bonds.slots.of(i);
      set_vector<3>(simulation.state.u, slot, Vec<3>(0.02 * X[1] * X[1], 0.01 * X[2], -0.01 * X[0] * X[1]));
      set_vector<3>(simulation.state.v, slot, Vec<3>(X[2], X[0] * X[0], 0.1 * X[1]));
    }
  }
};

void for_blocks(Solid<3>& solid, auto&& f) {
  for (Index b = 0; b < solid.blocks(); ++b) f(solid.block(b));
}

void stress_kernel(Body& body) {
  auto& solid = body.simulation.solid;
  for_blocks(solid, [&](const Block& block) {
    solid.sweeps.stress(solid.bonds, body.simulation.state.u, block, body.simulation.integrator.workspace->P,
                        nullptr);
  });
}

void force_kernel(Body& body) {
  auto& solid = body.simulation.solid;
  for_blocks(solid, [&](const Block& block) {
    BlockForce<3> force(block);
    solid.sweeps.force(solid.bonds, body.simulation.integrator.workspace->P, block, force);
    benchmark::DoNotOptimize(force(0, block.begin()));
  });
}

void jst_kernel(Body& body) {
  auto& solid = body.simulation.solid;
  const Term<3>& jst = solid.terms.front();
  const Instant<3> now{body.simulation.state, 0, *body.simulation.integrator.workspace, solid.terms};
  for_blocks(solid, [&](const Block& block) { jst.first(solid, block, now); });
  for_blocks(solid, [&](const Block& block) {
    BlockForce<3> force(block);
    jst.second(solid, block, now, force);
    benchmark::DoNotOptimize(force(0, block.begin()));
  });
}

void all_pairs_kernel(Body& body) {
  benchmark::DoNotOptimize(least_distance(body.simulation.solid, body.simulation.state));
}

/// Stresses alone, from deformation gradients that are at hand.
void material_kernel(Body& body) {
  const auto& solid = body.simulation.solid;
  const NeoHookean material(solid.elastic);
  using Real = Pack<native_width>;
  Mat<3, Real> F = Mat<3, Real>::Identity();
  Real sum(0);
  for (Index n = 0; n < solid.cloud.size(); n += native_width) {
    F(0, 1) = Real(1e-6 * static_cast<double>(n));
    sum += material.first_piola(F)(0, 1);
  }
  benchmark::DoNotOptimize(sum.lanes);
}

void neighbours_kernel(Body& body) {
  benchmark::DoNotOptimize(
      find_neighbours<3>(body.cloud, body.options.kernel.support * body.options.smoothing_length)
          .list.data());
}

void table_kernel(Body& body) {
  benchmark::DoNotOptimize(make_bond_table<3>(body.cloud, body.options).pairs);
}

/// Follows the closest pairs from their second use on: the first one collects them.
auto closest_kernel() {
  return [closest = std::make_shared<ClosestPairs<3>>()](Body& body) {
    benchmark::DoNotOptimize(closest->distance(body.simulation.solid, body.simulation.state));
  };
}

/// Keeps the numbers instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(long particles) : particles_(particles) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const auto& run : runs) {
      const std::string name = run.run_name.function_name;
      const auto slash = name.find('/');
      const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      times.push_back({name.substr(0, slash), name.substr(slash + 1), particles_,
                       seconds * 1e9 / static_cast<double>(particles_)});
    }
  }
  std::vector<KernelTime> times;

 private:
  long particles_;
};

}  // namespace

std::vector<KernelTime> measure_kernels(long particles, double seconds) {
  omp_set_num_threads(1);
  long count = 0;
  for (const bool irregular : {false, true}) {
    const auto body = std::make_shared<Body>(block(particles, irregular));
    body->simulation.integrator.workspace->P = StressWindow(
        9, body->simulation.solid.blocks(), body->simulation.solid.blocks(), 1);  // all stresses at once
    count = body->cloud.size();
    const auto add = [&](const char* name, const std::function<void(Body&)>& kernel) {
      const std::string full = fmt::format("{}/{}", name, irregular ? "jittered" : "lattice");
      benchmark::RegisterBenchmark(full.c_str(), [body, kernel](benchmark::State& state) {
        kernel(*body);  // warms up
        for ([[maybe_unused]] auto _ : state) kernel(*body);
      })->MinTime(seconds);
    };
    add("stress sweep", stress_kernel);
    add("force sweep", force_kernel);
    add("JST", jst_kernel);
    add("closest pairs followed", closest_kernel());
    add("distances of all pairs", all_pairs_kernel);
    if (!irregular) add("neo-Hookean stress", material_kernel);
    add("neighbour search", neighbours_kernel);
    add("bond table set-up", table_kernel);
  }
  Collector collector(count);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.times;
}

}  // namespace plumb::app::bench
