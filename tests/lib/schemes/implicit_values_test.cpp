// Values of an independent implementation of paper 004 (dual supports, quintic kernel): operator, energies
// and equilibria.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/bonds/own_supports.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/parts/slope_hourglass.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;
using testing::dual_body;

/// The other implementation agrees with itself to its printed 14 digits; sums here are in another order.
constexpr double digits = 1e-11;

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

TEST(DualSupports, ReachToTheNeighbourOfThatNumber) {
  const SmallCloud c;
  const std::vector<double> radii = support_radii(c.cloud, 12);
  for (Index i = 0; i < c.cloud.size(); ++i) {
    Index nearer = 0, within = 0;  // others than i
    for (Index j = 0; j < c.cloud.size(); ++j) {
      const double r = (c.cloud.X[j] - c.cloud.X[i]).norm();
      if (j != i && r < radii[i]) ++nearer;
      if (j != i && r <= radii[i]) ++within;
    }
    EXPECT_EQ(nearer, 11) << i;
    EXPECT_EQ(within, 12) << i;
  }
  EXPECT_THROW(support_radii(c.cloud, 30), InputError);
}

TEST(DualSupports, OfTooFewNeighboursAreRefused) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, {4, 4}, Layout::node);
  // a corner sees one other particle inside
  EXPECT_THROW(dual_body<2>(cloud, std::vector<double>(cloud.X.size(), 0.2), "neo-hookean", {10, 0.3, 1}),
               InputError);
}

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
  EXPECT_NEAR(energy("neo-hookean-logarithmic"), 0.065331534712774, digits);
}

TEST(DualSupports, TheHourglassEnergyHasItsValue) {
  const SmallCloud c;
  const auto energy = [&](double alpha) {
    return testing::energy_of_all(dual_body<2>(c.cloud, c.radius, "linear-elastic", {10, 0.3, 1}, alpha))
        .energy(c.u);
  };
  EXPECT_NEAR(energy(1) - energy(0), 0.0050439573059464, digits);
  EXPECT_NEAR(energy(3) - energy(0), 3 * 0.0050439573059464, 3 * digits);
}

TEST(DualSupports, ForcesAndStiffnessHaveTheirValues) {
  const SmallCloud c;
  const auto check = [&](const char* law, double force, double trace) {
    DiscreteEnergy<2> energy = testing::energy_of_all(dual_body<2>(c.cloud, c.radius, law, {10, 0.3, 1}, 1));
    EXPECT_NEAR(energy.residual(c.u).value().norm(), force, 1e-10) << law;
    energy.linearise_at(c.u);
    EXPECT_NEAR(SparseMatrix(energy.tangent()).diagonal().sum(), trace, 1e-7)
        << law;  // to its printed digits
  };
  check("linear-elastic", 2.3777720048193, 1814.5035000984);
  check("neo-hookean", 2.3236163719055, 1879.0106621596);
  check("neo-hookean-logarithmic", 2.6271025655774, 1904.6538690317);
}

/// Hourglass energy of the alternating motion a (-1)^(i + j) on a lattice of spacing 1, mu = 1, alpha = 1.
double alternating_energy(Index columns, Index rows, double reach, double a) {
  const Vec<2> size(static_cast<double>(columns), static_cast<double>(rows));
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), size}, {columns, rows}, Layout::cell);
  const std::vector<double> radius(cloud.X.size(), reach);
  const Solid<2> solid = dual_body<2>(cloud, radius, "neo-hookean", {2.6, 0.3, 1}, 1);
  State<2> state = make_state(solid);
  for (Index i = 0; i < cloud.size(); ++i)
    state.u[0][solid.bonds.slots.of(i)] = std::lround(cloud.X[i].sum() - 1) % 2 ? -a : a;
  return solid.terms.back().energy(solid, state);
}

/// E(m, n) = inside m n + edges (m + n) + corners: the mixed difference is what is inside.
TEST(DualSupports, AlternatingMotionHasItsEnergy) {
  struct Value {
    double reach, energy;
  };
  for (const Value& value :
       {Value{1.5, 3.99510404}, Value{2.05, 3.30921941}, Value{2.2, 3.06952712}, Value{3, 1.91984906}}) {
    const auto energy = [&](Index m, Index n) { return alternating_energy(m, n, value.reach, 1e-3); };
    const double inside = (energy(14, 14) - energy(12, 14) - energy(14, 12) + energy(12, 12)) / 4;
    EXPECT_NEAR(inside / 1e-6, value.energy, 1e-7) << value.reach;  // differences of sums of 200 terms
  }
}

/// Cube of 7^3 particles, half of whose upper face is pressed by p = 1 where E = 10; its line y = 1/2 has
/// half the weight.
struct Pressed {
  double u_y, u_z, energy, reaction;  ///< energy: without that of the hourglass term
};

Pressed pressed_cube(double alpha) {
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
  const Solid<3> solid = dual_body<3>(cloud, radius, "neo-hookean", {10, 0.3, 1}, alpha);
  State<3> state = make_state(solid);
  ImplicitOptions options;
  options.tolerance = 1e-12;
  const auto result = find_equilibrium<3>(solid, actions, 1, options, state);
  EXPECT_TRUE(result.completed());
  const Vec<3> u = vector_at<3>(state.u, solid.bonds.slots.of(corner));
  const Solid<3> bare = dual_body<3>(solid.cloud, radius, "neo-hookean", {10, 0.3, 1});
  return {u[1], u[2], testing::energy_of_all(bare).energy(unknowns_of(solid, state.u)),
          result.reactions[0].force[2]};
}

TEST(DualSupports, ThePressedCubeHasItsValues) {
  const Pressed plain = pressed_cube(0);
  EXPECT_NEAR(plain.u_y, -0.11060930717558, 1e-9);
  EXPECT_NEAR(plain.u_z, -0.15723055400667, 1e-9);
  EXPECT_NEAR(plain.energy, 0.025121046876861, 1e-10);
  EXPECT_NEAR(plain.reaction, 0.5, 1e-10);
  const Pressed stiffened = pressed_cube(1);
  EXPECT_NEAR(stiffened.u_y, -0.10141515174077, 1e-9);
  EXPECT_NEAR(stiffened.u_z, -0.14398565592424, 1e-9);
  EXPECT_NEAR(stiffened.energy, 0.023213136949221, 1e-10);
}

/// Rubber of paper 004, 6.5, in N and mm: a sheet of 2 x 2, E = 0.2, nu = 0.45, whose upper side is pulled up.
struct Pulled {
  double force, energy;  ///< energy: without that of the hourglass term
};

/// `nearest`: neighbours in the support of each particle; 0: a radius of 2.05 spacings.
Pulled pulled_rubber(Index cells, double pull, long nearest, double alpha) {
  Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>(2, 2)}, {cells, cells}, Layout::node);
  const std::vector<double> radius =
      nearest > 0 ? support_radii(cloud, nearest) : std::vector<double>(cloud.X.size(), 2.05 * cloud.spacing);
  std::vector<Support<2>> lower;
  Held<2> upper;
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; k < 2; ++k) {
      if (cloud.X[i][1] < 1e-9) lower.push_back({i, k});
      if (cloud.X[i][1] > 2 - 1e-9) upper.places.push_back({i, k, cloud.X[i]});
    }
  upper.motion = [pull](const Vec<2>&, int component, double) {
    return HeldMotion{component == 1 ? pull : 0.0, 0, 0};
  };
  Actions<2> actions = holding<2>(cloud, lower);
  actions.held.push_back(upper);
  const Elastic rubber{0.2, 0.45, 1};
  const Solid<2> solid = dual_body<2>(cloud, radius, "neo-hookean-logarithmic", rubber, alpha);
  State<2> state = make_state(solid);
  ImplicitOptions options;
  options.steps = 20;
  options.tolerance = 1e-12;
  const auto result = find_equilibrium<2>(solid, actions, 1, options, state);
  EXPECT_TRUE(result.completed());
  const Solid<2> bare = dual_body<2>(solid.cloud, radius, "neo-hookean-logarithmic", rubber);
  return {result.reactions.back().force[1], testing::energy_of_all(bare).energy(unknowns_of(solid, state.u))};
}

/// Digits that two other implementations have, one of them for both radii. A support that reaches to the twelfth neighbour gives that
/// one no weight.
TEST(DualSupports, ThePulledRubberHasItsValues) {
  const Pulled plain = pulled_rubber(10, 5, 0, 0), stiffened = pulled_rubber(10, 5, 0, 5);
  EXPECT_NEAR(plain.force, 0.52074081683892, 1e-9);
  EXPECT_NEAR(plain.energy, 1.5899391700887, 1e-9);
  EXPECT_NEAR(stiffened.force, 0.53873929477307, 1e-9);
  EXPECT_NEAR(stiffened.energy, 1.6121664666178, 1e-9);
  const Pulled nearest = pulled_rubber(10, 5, 12, 0);
  EXPECT_NEAR(nearest.force, 0.51187841038129, 1e-9);
  EXPECT_NEAR(nearest.energy, 1.56561531706024, 1e-9);
  EXPECT_NEAR(pulled_rubber(10, 5, 12, 5).force, 0.53510540147802, 1e-9);
}

/// Six times its height: 21 x 21 particles with supports to the twelfth neighbour.
TEST(DualSupports, ThePulledRubberOfThePaperHasItsValues) {
  const Pulled plain = pulled_rubber(20, 10, 12, 0);
  EXPECT_NEAR(plain.force, 0.83933975055163, 1e-8);
  EXPECT_NEAR(plain.energy, 4.92793314517424, 1e-8);
  EXPECT_NEAR(pulled_rubber(20, 10, 12, 5).force, 0.86309599998962, 1e-8);
}

}  // namespace
}  // namespace plumb
