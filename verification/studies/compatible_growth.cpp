// What the projection of compatible bonds costs as clouds grow in 3D (THEORY chapter 11).
#include <fmt/format.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <ctime>
#include <iostream>

#include "plumbline/compatible/compatible.hpp"
#include "plumbline/geometry/neighbours.hpp"
#include "plumbline/gradient/estimator.hpp"
#include "plumbline/kernel/kernel.hpp"
#include "plumbline/momentum/momentum_form.hpp"

using namespace plumb;

namespace {

double cpu_now() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double peak_gigabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1048576;
}

/// A cube of n^3 particles on a node layout, jittered by 0.2.
CompatibleReport project_cube(Index n, double volume_weight,
                              ProjectionSolver solver = ProjectionSolver::automatic) {
  const Box<3> box{Vec<3>::Zero(), Vec<3>::Ones()};
  Cloud<3> cloud = jittered<3>(lattice<3>(box, {n - 1, n - 1, n - 1}, Layout::node), 0.2, 7, Layout::node);
  BondOptions<3> options;
  options.kernel = kernel_named<3>("cubic");
  options.smoothing_length = 0.9 * cloud.spacing;
  options.pair = Pair::W1;
  options.estimator = estimator_named<3>("improved");
  options.momentum = momentum_form_named<3>("adjoint");
  double start = cpu_now();
  std::vector<std::vector<BondConstants<3>>> bonds(static_cast<std::size_t>(cloud.size()));
  {
    const Neighbours all = find_neighbours<3>(cloud, options.kernel.support * options.smoothing_length);
    for (Index i = 0; i < cloud.size(); ++i) bonds[i] = bonds_of<3>(cloud, all.of(i), i, options);
  }
  const double table = cpu_now() - start;
  CompatibleOptions<3> how;
  how.volume_weight = volume_weight;
  how.solver = solver;
  start = cpu_now();
  const auto report = make_compatible<3>(cloud, bonds, options.kernel, options.smoothing_length, how);
  std::cout << fmt::format(
      "{} particles, volumes {}: start table {:.1f} s, projection {:.1f} CPU-s, {} iterations in {} rounds, "
      "{} "
      "levels, constraints to {:.1e}, volumes by {:.1e}, {:.2f} GB at most so far\n",
      cloud.size(), volume_weight > 0 ? "unknown" : "fixed", table, cpu_now() - start, report.iterations,
      report.refinements, report.levels, report.residual, report.largest_volume_change, peak_gigabytes());
  return report;
}

const double unknown = CompatibleOptions<3>{}.volume_weight, fixed_volumes = 0;

}  // namespace

// Times are printed, not checked; the work of an iteration is proportional to the number of particles.
TEST_CASE("compatible: iterations of the projection hardly grow with the cloud", "[compatible][growth]") {
  for (const double weight : {fixed_volumes, unknown}) {
    const auto small = project_cube(14, weight, ProjectionSolver::iterative),
               large = project_cube(22, weight, ProjectionSolver::iterative);
    CHECK(large.residual < 1e-12);
    CHECK(large.iterations > 0);
    CHECK(large.iterations < 1.5 * small.iterations);  // four times as many particles
  }
}

TEST_CASE("compatible: projection of 1e4 to 1e5 particles", "[compatible][growth][long]") {
  for (const double weight : {fixed_volumes, unknown})
    for (const Index n : {22, 34, 47}) CHECK(project_cube(n, weight).residual < 1e-12);
}

TEST_CASE("compatible: projection of 1e6 particles", "[compatible][million][long]") {
  CHECK(project_cube(100, fixed_volumes).residual < 1e-12);
}
