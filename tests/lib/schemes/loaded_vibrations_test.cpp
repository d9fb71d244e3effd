// Vibrations about loaded states: against all eigenvalues of small bodies, and a column that buckles.
#include "lib/schemes/implicit/loaded_vibrations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/schemes/element/element.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"
#include "tests/support/mixed.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// The lowest eigenvalues of K x = w M x by a dense solver, also about a state that is not in balance.
template <int d>
void agrees_with_all_eigenvalues(double size) {
  const Solid<d> solid = testing::elastic_body<d>({"compatible"}, LawChoice("neo-hookean"), 0.5, 0.2);
  std::vector<Support<d>> supports;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d && solid.cloud.X[i][0] < 1e-9; ++k) supports.push_back({i, k});
  const Actions<d> actions = holding<d>(solid.cloud, supports);
  const VectorXd u = testing::smooth_motion(solid.cloud, size);
  Balance<d> balance(solid, actions, {1, 1}, u);
  const auto found = vibrations_about<d>(balance, u, 6);
  const VectorXd mass = balance.free_part(masses_of(solid));
  balance.linearise_at(u);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(Eigen::MatrixXd(balance.tangent()),
                                                                      Eigen::MatrixXd(mass.asDiagonal()));
  ASSERT_EQ(found.size(), 6u);
  const double scale = std::abs(all.eigenvalues()[5]);
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(found[k].square, all.eigenvalues()[k], 1e-7 * scale) << k;
    const VectorXd x = balance.free_part(found[k].shape), Kx = balance.tangent() * x;
    EXPECT_NEAR(x.dot(mass.cwiseProduct(x)), 1, 1e-12);
    EXPECT_NEAR(x.dot(Kx), found[k].square, 1e-9 * scale);
  }
}

TEST(LoadedVibrations, AreTheLowestOfAll) {
  for (const double size : {0.0, 0.05}) {
    agrees_with_all_eigenvalues<2>(size);
    agrees_with_all_eigenvalues<3>(size);
  }
}

/// omega^2 of a column of 20 x 1 m, nu = 0, clamped at its foot, under a dead load on its head, as a share of
/// Euler's load pi^2 E I/(4 L^2).
double lowest_square(double share) {
  const double E = 1e6, L = 20, euler = std::pow(std::numbers::pi, 2) * E / 12 / (4 * L * L);
  Cloud<2> cloud = testing::nodes<2>({0, 0}, {1, L}, {2, 40});
  Held<2> foot{"foot", {}, [](const Vec<2>&, int, double) { return HeldMotion{}; }};
  SurfaceLoad<2> head;
  head.name = "head";
  head.steady = true;
  head.traction = [=](const Vec<2>&, const Vec<2>&, double) -> Vec<2> { return {0, -share * euler}; };
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<2>& X = cloud.X[i];
    for (int k = 0; k < 2 && X[1] < 1e-9; ++k) foot.places.push_back({i, k, X});
    const bool rim = X[0] < 1e-9 || X[0] > 1 - 1e-9;
    if (X[1] > L - 1e-9) head.places.push_back({i, X, (rim ? 0.25 : 0.5) * Vec<2>::UnitY()});
  }
  Actions<2> actions;
  actions.held = {foot};
  actions.surface = {head};
  ElementOptions options;
  options.order = "quadratic";
  const Element<2> column({std::move(cloud), LawChoice("saint-venant-kirchhoff"), {E, 0, 1000}}, options,
                          actions);
  BodyMotion motion{VectorXd::Zero(2 * column.body().cloud.size()),
                    VectorXd::Zero(2 * column.body().cloud.size())};
  // one step: without a push to the side the column stays straight beyond its load, too
  ImplicitOptions one;
  one.steps = 1;
  const auto result = find_equilibrium<2>(column.stored_energy(), column.actions(), 1, one, motion);
  EXPECT_TRUE(result.completed());
  Balance<2> balance(column.stored_energy(), column.actions(), {1, 1}, motion.u);
  return vibrations_about<2>(balance, motion.u, 2)[0].square;
}

/// omega^2 falls in proportion to the load and is zero at Euler's.
TEST(LoadedVibrations, AColumnBucklesAtEulersLoad) {
  const double free = lowest_square(0), half = lowest_square(0.5), near = lowest_square(0.9);
  // first frequency of a slender cantilever: (1.8751^2/L^2)^2 E I/(rho A); shear and rotation take 1 % at
  // L/20
  const double beam = std::pow(1.875104 / 20, 4) * 1e6 / 12 / 1000;
  EXPECT_NEAR(free, beam, 0.02 * beam);
  EXPECT_NEAR(half / free, 0.5, 0.03);  // the first mode changes on the way
  const double beyond = lowest_square(1.1);
  EXPECT_LT(beyond, 0);  // the straight column is an equilibrium, and unstable
  EXPECT_NEAR(0.9 + 0.2 * near / (near - beyond), 1, 0.01);  // shear takes 0.5 % off Euler's load
}

TEST(LoadedVibrations, APressureThatFollowsIsRefused) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0);
  Actions<2> actions;
  SurfaceLoad<2> load;
  load.pressure = [](const Vec<2>&, double) { return 1.0; };
  load.places.push_back({0, solid.cloud.X[0], Vec<2>::UnitX()});
  actions.surface.push_back(load);
  const VectorXd u = VectorXd::Zero(2 * solid.cloud.size());
  Balance<2> balance(solid, actions, {1, 1}, u);
  EXPECT_THROW(vibrations_about<2>(balance, u, 2), InputError);
}

}  // namespace
}  // namespace plumb
