// What the projection of compatible bonds costs as clouds grow in 3D (THEORY chapter 11).
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <iostream>
#include <set>

#include "lib/geometry/neighbours.hpp"
#include "lib/kernel/kernel.hpp"
#include "lib/schemes/tlsph/bonds/estimator.hpp"
#include "lib/schemes/tlsph/bonds/momentum_form.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"

namespace plumb::compatible_growth_study {

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

BondOptions<3> cube_options(double h) {
  BondOptions<3> options;
  options.kernel = kernel_named<3>("cubic");
  options.smoothing_length = h;
  options.pair = Correction::W1;
  options.estimator = estimator_named<3>("improved");
  options.momentum = momentum_form_named<3>("adjoint");
  return options;
}

std::vector<std::vector<BondConstants<3>>> start_table(const Cloud<3>& cloud, const BondOptions<3>& options) {
  std::vector<std::vector<BondConstants<3>>> bonds(static_cast<std::size_t>(cloud.size()));
  const Neighbours all = find_neighbours<3>(cloud, options.kernel.support * options.smoothing_length);
  for (Index i = 0; i < cloud.size(); ++i) bonds[i] = bonds_of<3>(cloud, all.of(i), i, options);
  return bonds;
}

/// A cube of n^3 particles on a node layout, jittered by 0.2.
CompatibleReport project_cube(Index n, double volume_weight,
                              ProjectionSolver solver = ProjectionSolver::automatic) {
  const Box<3> box{Vec<3>::Zero(), Vec<3>::Ones()};
  Cloud<3> cloud = jittered<3>(lattice<3>(box, {n - 1, n - 1, n - 1}, Layout::node), 0.2, 7, Layout::node);
  const BondOptions<3> options = cube_options(0.9 * cloud.spacing);
  double start = cpu_now();
  auto bonds = start_table(cloud, options);
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
  const auto report = project_cube(100, unknown);
  CHECK(report.residual < 1e-12);
  CHECK(report.iterations < 180);  // 118 for a tenth of the particles; 222 with a coarsest grid too wide
}

namespace {

/// Area vectors of a particle's bonds in d^2, one after the other; neighbours stand in the same order
/// everywhere.
std::vector<double> row_of(const Cloud<3>& cloud, const std::vector<BondConstants<3>>& bonds, Index i) {
  std::vector<double> row;
  for (const auto& bond : bonds)
    for (int k = 0; k < 3; ++k)
      row.push_back(2 * cloud.V[i] * bond.stencil[k] / (cloud.spacing * cloud.spacing));
  return row;
}

/// How many layers a particle lies below the surface.
Index depth_of(Index i, Index n) {
  Index depth = n;
  for (const Index at : {i / (n * n), i / n % n, i % n}) depth = std::min({depth, at, n - 1 - at});
  return depth;
}

/// Projects a lattice of n^3 nodes; prints by depth how far whole rows are from that of the middle.
/// @return the number of rows that differ by more than 1e-9 d^2.
std::size_t different_rows(Index n) {
  Cloud<3> cloud = lattice<3>({Vec<3>::Zero(), Vec<3>::Constant(static_cast<double>(n - 1))},
                              {n - 1, n - 1, n - 1}, Layout::node);
  const BondOptions<3> options = cube_options(1.2 * cloud.spacing);
  auto bonds = start_table(cloud, options);
  const auto report = make_compatible<3>(cloud, bonds, options.kernel, options.smoothing_length, {});
  CHECK(report.residual < 1e-12);
  const Index middle = (n / 2 * n + n / 2) * n + n / 2;
  const auto wanted = row_of(cloud, bonds[middle], middle);
  std::vector<double> furthest(n, 0.0);
  std::set<std::vector<std::int64_t>> rows;
  for (Index i = 0; i < cloud.size(); ++i) {
    const auto row = row_of(cloud, bonds[i], i);
    std::vector<std::int64_t> rounded;
    rounded.reserve(row.size());
    for (const double value : row) rounded.push_back(std::llround(1e9 * value));
    rows.insert(rounded);
    if (row.size() != wanted.size()) continue;
    double& most = furthest[depth_of(i, n)];
    for (std::size_t k = 0; k < row.size(); ++k) most = std::max(most, std::abs(row[k] - wanted[k]));
  }
  std::cout << fmt::format("lattice of {}^3: {} different rows; by depth from the middle's:", n, rows.size());
  for (Index depth = 0; depth <= n / 2; ++depth) std::cout << fmt::format(" {:.2g}", furthest[depth]);
  std::cout << '\n';
  return rows.size();
}

}  // namespace

// What a boundary needs reaches through the whole body: nothing is left to be shared. The symmetries of a
// cube would allow 48 times fewer rows than particles at best.
TEST_CASE("compatible: no two rows of a lattice are alike", "[compatible][lattice-rows]") {
  CHECK(different_rows(16) == 16 * 16 * 16);
}
TEST_CASE("compatible: no two rows of a larger lattice are alike", "[compatible][lattice-rows][long]") {
  CHECK(different_rows(32) == 32 * 32 * 32);
}

}  // namespace plumb::compatible_growth_study
