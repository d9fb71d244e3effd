// Conjugate gradients on two levels: the same equilibria as by factors, with a number of iterations that does not grow with the
// cloud.
#include "lib/schemes/implicit/two_level.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/linear/conjugate_gradients.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/implicit/load_path.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {
namespace {

TEST(ConjugateGradients, FindTheSolutionOfAPositiveSystem) {
  Eigen::Matrix3d K;
  K << 4, 1, 0, 1, 3, -1, 0, -1, 5;
  const Eigen::Vector3d x(1, -2, 0.5);
  const auto product = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return K * v; };
  const auto diagonal = [&](const Eigen::VectorXd& r) -> Eigen::VectorXd {
    return r.cwiseQuotient(K.diagonal());
  };
  const Conjugated found = conjugate_gradients(product, diagonal, K * x, 1e-13, 20);
  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.iterations, 4);  // three unknowns, and one for rounding
  EXPECT_LT((found.x - x).norm(), 1e-12);
  const Conjugated nothing = conjugate_gradients(product, diagonal, Eigen::Vector3d::Zero(), 1e-13, 20);
  EXPECT_TRUE(nothing.converged);
  EXPECT_EQ(nothing.x.norm(), 0);
}

/// Where K is not positive, what was found is a direction of descent.
TEST(ConjugateGradients, SayThatASystemIsNotPositive) {
  const Eigen::Vector3d k(2, 3, -1), b(1, 1, 1);
  const auto product = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return k.cwiseProduct(v); };
  const auto none = [](const Eigen::VectorXd& r) { return r; };
  const Conjugated found = conjugate_gradients(product, none, b, 1e-12, 20);
  EXPECT_TRUE(found.indefinite);
  EXPECT_FALSE(found.converged);
  EXPECT_GT(b.dot(found.x), 0);
}

Scene sheared_plate(double spacing, double alpha, const std::string& more = "") {
  return parse_scene(fmt::format(R"([scene]
dimension = 2
end_time = "1 s"
[body]
size = [1, 1]
spacing = {}
layout = "node"
jitter = 0.2
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = "implicit"
gradient = "compatible"
[hourglass]
alpha = {}
[[boundary]]
face = "x-"
kind = "clamped"
[[boundary]]
face = "x+"
kind = "traction"
traction = ["0", "1 MPa"]
{})",
                                 spacing, alpha, more),
                     "plate.toml");
}

/// A body, its balance under the whole load, linearised at the reference.
struct Loaded {
  TlsphBody<2> body;
  Balance<2> balance;
  explicit Loaded(const Scene& scene)
      : body(make_tlsph<2>(scene)),
        balance(stored_energy(body.solid), body.actions, {1, 1},
                Eigen::VectorXd::Zero(2 * body.solid.cloud.size())) {
    balance.linearise_at(Eigen::VectorXd::Zero(2 * body.solid.cloud.size()));
  }
  Eigen::VectorXd product(const Eigen::VectorXd& v) const {
    return balance.free_part(balance.tangent_times(balance.whole(v)));
  }
  Eigen::VectorXd right() const {
    return -balance.free_part(*balance.residual(Eigen::VectorXd::Zero(2 * body.solid.cloud.size())));
  }
};

int iterations_of(const Scene& scene) {
  Loaded plate(scene);
  TangentSolver<2> solver(plate.balance, LinearSolver::iterative);
  const Eigen::VectorXd b = plate.right();
  const auto found = solver.solve(plate.balance, b, 1e-8);
  EXPECT_TRUE(found.has_value());
  EXPECT_LT((plate.product(found->x) - b).norm(), 1e-7 * b.norm());
  return static_cast<int>(solver.iterations());
}

TEST(TwoLevel, IsSymmetricAndPositive) {
  const Loaded plate(sheared_plate(0.1, 1));
  const auto K = [&](const Eigen::VectorXd& v) { return plate.product(v); };
  const DiscreteEnergy<2>& energy = plate.balance.energy();
  TwoLevel<2> levels(energy.cloud(), energy.operators(), energy.unknowns());
  levels.move_to(energy.material(), {}, K);
  const auto n = static_cast<Index>(energy.unknowns().size());
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(n, -1, 2), b = a.array().sin() + 0.3;
  const Eigen::VectorXd Ma = levels(K, a), Mb = levels(K, b);
  // sums of n products with rounding; factors of the coarse grid
  EXPECT_NEAR(Ma.dot(b), a.dot(Mb), 1e-11 * Ma.norm() * b.norm());
  EXPECT_GT(Ma.dot(a), 0);
  EXPECT_GT(Mb.dot(b), 0);
}

/// P^T K P by columns of K, below the diagonal; a motion that moves no free unknown has a stiffness of 1.
TEST(TwoLevel, TheGridHasTheStiffnessOfItsMotions) {
  for (const double alpha : {0.0, 1.0}) {
    const Loaded plate(sheared_plate(0.1, alpha));
    const DiscreteEnergy<2>& energy = plate.balance.energy();
    const CoarseGrid<2> grid(energy.cloud(), energy.operators(), energy.unknowns());
    const Eigen::MatrixXd P(grid.motions());
    Eigen::MatrixXd expected(P.cols(), P.cols());
    for (Index n = 0; n < P.cols(); ++n) expected.col(n) = P.transpose() * plate.product(P.col(n));
    int still = 0;
    for (Index n = 0; n < P.cols(); ++n)
      if (P.col(n).norm() == 0) expected(n, n) = 1, ++still;
    EXPECT_EQ(still, 0);  // a layer of cells that is held all around would have some
    const Eigen::MatrixXd found =
        Eigen::MatrixXd(grid.stiffness(energy.material())).triangularView<Eigen::Lower>();
    const Eigen::MatrixXd lower = expected.triangularView<Eigen::Lower>();
    EXPECT_LT((found - lower).norm(), 1e-12 * lower.norm()) << alpha;
  }
}

/// The hourglass energy makes the number of iterations that of the cell, not of the body: four and sixteen times as many particles.
TEST(TwoLevel, IterationsDoNotGrowWithTheCloud) {
  const int coarse = iterations_of(sheared_plate(0.05, 1)), middle = iterations_of(sheared_plate(0.025, 1)),
            fine = iterations_of(sheared_plate(0.0125, 1));
  EXPECT_LE(coarse, 10);  // they are 7
  EXPECT_LE(middle, 1.5 * coarse);
  EXPECT_LE(fine, 1.5 * coarse);
}

Snapshot<2> end_of_search(Scene scene, LinearSolver solver) {
  scene.method.implicit.solver = solver;
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord record;
  EXPECT_TRUE(run<2>(simulation, {}, record).completed());
  return simulation.snapshot();
}

/// At finite strain and with inertia, by bonds and by elements, where the law flows and where it does not.
TEST(TwoLevel, FindsTheEquilibriaThatFactorsFind) {
  Scene by_elements = sheared_plate(0.125, 1);
  by_elements.method.hourglass.reset();
  by_elements.body.jitter = 0;
  by_elements.method.scheme = "element";
  by_elements.method.element.solve = "newton";
  Scene flows = sheared_plate(0.125, 1);
  flows.material.model = "j2-logarithmic";
  flows.material.parameters = {{"yield", 2e6}, {"hardening", 3e6}};
  Scene moves = sheared_plate(0.125, 1, "[implicit]\ndynamics = \"midpoint\"\ntime_step = 0.01\n");
  moves.end_time = 0.05;
  for (const Scene& scene : {sheared_plate(0.1, 0), sheared_plate(0.1, 1), by_elements, flows, moves}) {
    const Snapshot<2> a = end_of_search(scene, LinearSolver::direct),
                      b = end_of_search(scene, LinearSolver::iterative);
    double most = 0;
    for (const auto& u : a.u) most = std::max(most, u.norm());
    EXPECT_GT(most, 0.02);
    for (std::size_t i = 0; i < a.u.size();
         ++i)  // residuals of 1e-10 of the forces; soft motions take up thousands of that
      EXPECT_LT((a.u[i] - b.u[i]).norm(), 1e-6 * most) << i;
  }
}

/// The steps are asked for to the square of what is left, so Newton's method stays quadratic.
TEST(TwoLevel, NewtonsMethodStaysQuadratic) {
  Loaded plate(sheared_plate(0.1, 1));
  TangentSolver<2> solver(plate.balance, LinearSolver::iterative);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(2 * plate.body.solid.cloud.size());
  const NewtonResult found = newton(plate.balance, solver, 1e-12, u);
  ASSERT_TRUE(found.converged());
  int judged = 0;
  for (std::size_t n = 0; n + 1 < found.residuals.size(); ++n) {
    const double now = found.residuals[n], next = found.residuals[n + 1];
    if (now > 1e-2 || next < 1e-11) continue;
    EXPECT_GT(std::log(next) / std::log(now), 1.8) << now << " " << next;
    ++judged;
  }
  EXPECT_GE(judged, 1);
  EXPECT_LE(solver.levels(), 4);  // made anew only where iterations become many
}

TEST(TwoLevel, APressureThatFollowsIsRefused) {
  Scene scene = sheared_plate(0.25, 1);
  scene.boundaries.back().kind = BoundaryKind::pressure;
  scene.boundaries.back().pressure = Expression::constant(1e5);
  Loaded plate(scene);
  EXPECT_THROW(TangentSolver<2>(plate.balance, LinearSolver::iterative), InputError);
}

}  // namespace
}  // namespace plumb
