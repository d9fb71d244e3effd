// Conjugate gradients on two levels in three dimensions: iterations of small and of large clouds.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {
namespace {

/// Iterations to 1e-8 on a cube of jittered particles with compatible bonds and hourglass energy, one side held, the other sheared.
long iterations_of_cube(int cells) {
  const Scene scene = parse_scene(fmt::format(R"([scene]
dimension = 3
end_time = "1 s"
[body]
size = [1, 1, 1]
spacing = {:.17g}
jitter = 0.2
[material]
model = "linear-elastic"
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = "implicit"
gradient = "compatible"
[hourglass]
alpha = 1
[[boundary]]
face = "x-"
kind = "clamped"
[[boundary]]
face = "x+"
kind = "traction"
traction = ["0", "1 kPa", "0"]
)",
                                              1.0 / cells),
                                  "cube.toml");
  const TlsphBody<3> body = make_tlsph<3>(scene);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(3 * body.solid.cloud.size());
  Balance<3> balance(stored_energy(body.solid), body.actions, {1, 1}, rest);
  TangentSolver<3> solver(balance, LinearSolver::iterative);
  balance.linearise_at(rest);
  solver.linearise_at(balance, rest);
  EXPECT_TRUE(solver.solve(balance, -balance.free_part(*balance.residual(rest)), 1e-8).has_value());
  std::cout << body.solid.cloud.size() << " particles: " << solver.iterations() << " iterations\n";
  return solver.iterations();
}

TEST(TwoLevelBlock, IterationsDoNotGrowWithTheCube) {
  const long coarse = iterations_of_cube(8), fine = iterations_of_cube(16);
  EXPECT_LE(coarse, 20);
  EXPECT_LE(static_cast<double>(fine), 1.5 * static_cast<double>(coarse));
}

/// 9261 and 97336 particles.
TEST(TwoLevelBlockLong, IterationsOf100000AreThoseOf10000) {
  const long coarse = iterations_of_cube(20), fine = iterations_of_cube(45);
  EXPECT_LE(static_cast<double>(fine), 1.5 * static_cast<double>(coarse));
}

}  // namespace
}  // namespace plumb
