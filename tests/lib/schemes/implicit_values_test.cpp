// Values of an independent implementation of paper 004 (dual supports, quintic kernel): operator, energies
// and equilibria.
#include <gtest/gtest.h>

#include <cmath>

#include "plumbline/boundary/supports.hpp"
#include "plumbline/gradient/each_bond.hpp"
#include "plumbline/schemes/implicit/equilibrium.hpp"
#include "plumbline/solid/kinematics.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// The other implementation agrees with itself to its printed 14 digits; sums here are in another order.
constexpr double digits = 1e-11;

template <int d>
Solid<d> dual_body(Cloud<d> cloud, const std::vector<double>& radius, const std::string& law,
                   const Elastic& elastic) {
  BondOptions<d> options = testing::options<d>({.estimator = "standard", .pair = Pair::none}, cloud.spacing);
  options.kernel = kernel_named<d>("quintic");
  options.smoothing_length = *std::max_element(radius.begin(), radius.end()) / options.kernel.support;
  options.project = [kernel = options.kernel, radius](Cloud<d>& particles, const Neighbours&, auto& bonds) {
    testing::set_dual_stencils<d>(particles, kernel, radius, bonds);
  };
  return make_solid<d>(std::move(cloud), law, elastic, options);
}

/// 6 x 5 particles, moved, with volumes and supports of their own; particle numbers run along x first.
struct SmallCloud {
  Cloud<2> cloud;
  std::vector<double> radius;
  VectorXd u{60};
  SmallCloud() {
    cloud.spacing = 0.1;
    cloud.box = {Vec<2>(-0.02, -0.02), Vec<2>(0.54, 0.44)};
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 6; ++i) {
        const double x = 0.1 * (i + 0.2 * std::sin(3 * i + 5 * j)),
                     y = 0.1 * (j + 0.2 * std::cos(2 * i - 3 * j));
        u[2 * cloud.size()] = 0.006 * (std::sin(20 * x) + 5 * y);
        u[2 * cloud.size() + 1] = 0.006 * 10 * x * std::cos(15 * y);
        cloud.X.emplace_back(x, y);
        cloud.V.push_back(0.01 * (1 + 0.1 * std::sin(i + 2 * j)));
        radius.push_back(0.1 * (2.4 + 0.5 * std::cos(i - j)));
      }
  }
};

TEST(DualSupports, TheOperatorHasItsValues) {
  const SmallCloud c;
  const Solid<2> solid = dual_body<2>(c.cloud, c.radius, "neo-hookean", {10, 0.3, 1});
  int neighbours = 0;
  for_each_bond(solid.bonds, 8, [&](const BondEntry<2>& bond, const Vec<2>& X) {
    if (X.norm() < c.radius[8]) ++neighbours;
    if (bond.other != 9) return;
    const Vec<2> stencil = bond.vector(solid.bonds.stencil);
    EXPECT_NEAR(stencil[0], 1.3695013577179, digits);
    EXPECT_NEAR(stencil[1], -0.18489374720972, digits);
  });
  EXPECT_EQ(neighbours, 18);
  State<2> state = make_state(solid);
  set_unknowns(solid, c.u, state.u);
  const Mat<2> F = deformation_gradient_of(solid, state, 8);
  EXPECT_NEAR(F(0, 0), 0.94924378872962, digits);
  EXPECT_NEAR(F(0, 1), 0.029428636399019, digits);
}

TEST(DualSupports, TheEnergiesHaveTheirValues) {
  const SmallCloud c;
  const auto energy = [&](const char* law) {
    return testing::energy_of_all(dual_body<2>(c.cloud, c.radius, law, {10, 0.3, 1})).energy(c.u);
  };
  EXPECT_NEAR(energy("linear-elastic"), 0.062774465325362, digits);
  EXPECT_NEAR(energy("neo-hookean"), 0.060828572904357, digits);
}

/// Cube of 7^3 particles, half of whose upper face is pressed by p = 1 where E = 10; its line y = 1/2 has
/// half the weight.
TEST(DualSupports, ThePressedCubeHasItsValues) {
  const Index n = 7;
  Cloud<3> cloud = lattice<3>({Vec<3>::Zero(), Vec<3>::Ones()}, {n - 1, n - 1, n - 1}, Layout::node);
  const double spacing = cloud.spacing;
  const std::vector<double> radius(cloud.X.size(), 2.05 * spacing);
  SurfaceLoad<3> load;
  load.name = "z+";
  load.steady = true;
  load.traction = [](const Vec<3>&, const Vec<3>& normal, double) -> Vec<3> { return -normal; };
  std::vector<Support<3>> supports;
  Index corner = -1;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<3>& X = cloud.X[i];
    const auto share = [&](int k) { return X[k] < 1e-9 || X[k] > 1 - 1e-9 ? 0.5 : 1.0; };
    for (int k = 0; k < 3 && X[2] < 1e-9; ++k) supports.push_back({i, k});
    if (X[2] < 1 - 1e-9) continue;
    if (X[0] < 1e-9 && X[1] < 1e-9) corner = i;
    const double line = std::abs(X[1] - 0.5) < 1e-9 ? 0.5 : 1;
    if (X[1] < 0.5 + 1e-9)
      load.places.push_back({i, X, line * share(0) * share(1) * spacing * spacing * Vec<3>::UnitZ()});
  }
  Actions<3> actions = holding<3>(cloud, supports);
  actions.surface.push_back(load);
  const Solid<3> solid = dual_body<3>(cloud, radius, "neo-hookean", {10, 0.3, 1});
  State<3> state = make_state(solid);
  ImplicitOptions options;
  options.tolerance = 1e-12;
  const auto result = find_equilibrium<3>(solid, actions, 1, options, state);
  ASSERT_TRUE(result.completed());
  const Vec<3> u = vector_at<3>(state.u, solid.bonds.slots.of(corner));
  EXPECT_NEAR(u[1], -0.11060930717558, 1e-9);
  EXPECT_NEAR(u[2], -0.15723055400667, 1e-9);
  EXPECT_NEAR(testing::energy_of_all(solid).energy(unknowns_of(solid, state.u)), 0.025121046876861, 1e-10);
  EXPECT_NEAR(result.reactions[0].force[2], 0.5, 1e-10);
}

}  // namespace
}  // namespace plumb
