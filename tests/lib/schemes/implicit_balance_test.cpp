// What acts from outside on the way to an equilibrium: dead loads, pressures that follow, held unknowns,
// rigid motions that nothing holds.
#include "lib/schemes/implicit/balance.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "lib/schemes/implicit/supported.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

template <class Case>
class ImplicitBalance : public ::testing::Test {};
using Bodies = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(ImplicitBalance, Bodies, test::Names);

/// Pressure and traction on the particles of the face x+, each with the same piece of it.
template <int d>
Actions<d> loads_on_a_face(const Cloud<d>& cloud, bool follows) {
  SurfaceLoad<d> load;
  load.name = "x+";
  for (const Index i : particles_on_face(cloud, 0, true, Layout::node))
    load.places.push_back({i, cloud.X[i], 0.1 * Vec<d>::Unit(0)});
  if (follows)
    load.pressure = [](const Vec<d>& at, double t) { return 1e6 * t * (1 + at[d - 1]); };
  else
    load.traction = [](const Vec<d>&, const Vec<d>& normal, double) -> Vec<d> { return 2e5 * normal; };
  load.steady = !follows;
  Actions<d> actions;
  actions.surface = {load};
  return actions;
}

TYPED_TEST(ImplicitBalance, TangentOfAPressureIsTheDerivative) {
  constexpr int d = TypeParam::d;
  const Solid<d> solid = testing::elastic_body<d>({}, LawChoice("neo-hookean"), 0.5, 0.2);
  const Actions<d> actions = loads_on_a_face<d>(solid.cloud, true);
  const VectorXd u = testing::smooth_motion(solid.cloud, 0.05);
  Balance<d> balance(solid, actions, {2.0, 1}, u);
  EXPECT_FALSE(balance.symmetric());
  test::Numbers numbers(8);
  VectorXd v(u.size());
  for (Index i = 0; i < u.size(); ++i) v[i] = numbers.next();
  balance.linearise_at(u);
  const VectorXd Kv = balance.tangent() * v;
  const double s = 1e-3 * solid.cloud.spacing;
  const auto r = [&](double t) { return balance.residual(u + t * s * v).value(); };
  // truncation (1e-3)^4, round-off 1e-13
  EXPECT_LT((Kv - (8 * (r(1) - r(-1)) - (r(2) - r(-2))) / (12 * s)).norm(), 1e-9 * Kv.norm());
  EXPECT_LT((Kv - balance.tangent_times(v)).norm(), 1e-13 * Kv.norm());
  const Actions<d> none;
  Balance<d> bare(solid, none, {2.0, 1}, u);
  bare.linearise_at(u);
  EXPECT_GT((Kv - bare.tangent() * v).norm(), 1e-4 * Kv.norm());  // 1e6 Pa beside 17e6: the pressure is felt
}

/// The residual is the slope of the potential, for loads with and without one of their own.
TYPED_TEST(ImplicitBalance, TheChangeOfPotentialHasTheResidualAsItsSlope) {
  constexpr int d = TypeParam::d;
  const Solid<d> solid = testing::elastic_body<d>({}, LawChoice("neo-hookean"), 0.5, 0.2);
  for (const bool follows : {false, true}) {
    const Actions<d> actions = loads_on_a_face<d>(solid.cloud, follows);
    const VectorXd u = testing::smooth_motion(solid.cloud, 0.05), v = testing::smooth_motion(solid.cloud, 1);
    Balance<d> balance(solid, actions, {1.0, 0.5}, u);
    const double s = 1e-3;
    double round_off = 0;
    const auto change = [&](double t) { return balance.change_of_potential(u, u + t * s * v, &round_off); };
    const double slope = (8 * (change(1) - change(-1)) - (change(2) - change(-2))) / (12 * s);
    const double expected = balance.residual(u).value().dot(v);
    EXPECT_NEAR(slope, expected, 1e-9 * std::abs(expected)) << follows;
    EXPECT_LT(round_off, 1e-10 * std::abs(change(1)));
    EXPECT_EQ(change(0), 0);
    // over a long step it is what it is over its halves: the work is taken exactly
    const VectorXd half = u + 0.02 * v, end = u + 0.04 * v;
    const double whole = balance.change_of_potential(u, end, &round_off);
    EXPECT_NEAR(
        whole,
        balance.change_of_potential(u, half, &round_off) + balance.change_of_potential(half, end, &round_off),
        1e-11 * std::abs(whole))
        << follows;
  }
}

TEST(ExternalLoads, ConstantOnesGrowWithTheShareAndOthersAreTakenAtItsTime) {
  const Cloud<2> cloud = testing::block<2>(4, Layout::node, 0);
  Actions<2> actions = loads_on_a_face<2>(cloud, false);  // 2e5 N/m^2 x 0.1 m on each of four particles
  actions.body_forces.push_back(
      {"gravity", [](const Vec<2>&, double t) { return Vec<2>(0, 300 * t); }, false});
  actions.body_forces.push_back({"gravity", [](const Vec<2>&, double) { return Vec<2>(0, 100); }, true});
  const ExternalLoads<2> loads(cloud, actions);
  EXPECT_FALSE(loads.follow());
  const VectorXd f = loads.dead({2.0, 0.25});
  double x = 0, y = 0, volume = 0;
  for (Index i = 0; i < cloud.size(); ++i) x += f[2 * i], y += f[2 * i + 1], volume += cloud.V[i];
  EXPECT_NEAR(x, 0.25 * 2e5 * 0.1 * 4, 1e-9);
  EXPECT_NEAR(y, volume * (300 * 2.0 + 0.25 * 100), 1e-9);
}

/// Nanson: a pressure on a closed surface pushes with p times the current area vectors, which turn with the
/// body.
TEST(ExternalLoads, APressureTurnsAndGrowsWithTheSurface) {
  const Cloud<3> cloud = testing::block<3>(3, Layout::node, 0);
  const Actions<3> actions = loads_on_a_face<3>(cloud, true);
  const ExternalLoads<3> loads(cloud, actions);
  EXPECT_TRUE(loads.follow());
  const Mat<3> F =
      Eigen::AngleAxisd(0.7, Vec<3>::UnitZ()) * Vec<3>(1, 1.5, 2).asDiagonal();  // areas x+: 3 times
  VectorXd gradients(9 * cloud.size());
  for (Index i = 0; i < cloud.size(); ++i)
    for (int n = 0; n < 9; ++n) gradients[9 * i + n] = F(n / 3, n % 3);
  const VectorXd f = loads.following({0.5, 1}, gradients);
  for (const LoadedPlace<3>& place : actions.surface[0].places) {
    const Vec<3> push = -0.5e6 * (1 + place.at[2]) * 0.1 * 3 * Vec<3>(std::cos(0.7), std::sin(0.7), 0);
    EXPECT_LT((f.segment<3>(3 * place.particle) - push).norm(), 1e-12 * push.norm());
  }
}

Held<2> held_by(std::function<HeldMotion(double)> motion, bool steady, Index particle) {
  return {"b",
          {{particle, 1, Vec<2>::Zero()}},
          [motion](const Vec<2>&, int, double t) { return motion(t); },
          steady};
}

TEST(HeldPath, DisplacementsAndVelocitiesTakeTheirUnknownsAlong) {
  Actions<2> actions;
  actions.held = {held_by(
                      [](double) -> HeldMotion {
                        return {0.2, 0, 0};
                      },
                      true, 0),
                  held_by(
                      [](double t) -> HeldMotion {
                        return {t * t, 2 * t, 2};
                      },
                      false, 1),
                  held_by(
                      [](double) -> HeldMotion {
                        return {std::nullopt, 3, 0};
                      },
                      true, 2),
                  held_by(
                      [](double t) -> HeldMotion {
                        return {std::nullopt, std::cos(t), 0};
                      },
                      false, 3),
                  held_by(
                      [](double) -> HeldMotion {
                        return {7.0, 0, 0};
                      },
                      true, 3)};
  EXPECT_EQ(held_unknowns(actions), (std::vector<Index>{1, 3, 5, 7}));
  VectorXd u = VectorXd::Constant(8, 0.5);
  put_held(actions, {2.0, 0.25}, VectorXd::Constant(8, 0.1), u);
  EXPECT_EQ(u[0], 0.5);  // free
  EXPECT_NEAR(u[1], 0.25 * 0.2, 1e-15);
  EXPECT_NEAR(u[3], 4, 1e-15);
  EXPECT_NEAR(u[5], 0.1 + 3 * 2, 1e-15);
  EXPECT_NEAR(u[7], 0.25 * 7, 1e-15);  // the later boundary wins
  actions.held.pop_back();
  put_held(actions, {2.0, 0.25}, VectorXd::Constant(8, 0.1), u);
  EXPECT_NEAR(u[7], 0.1 + std::sin(2.0), 1e-7);  // Simpson: (2/64)^4/180 of the integral
}

template <int d>
std::optional<std::string> freedom(const std::vector<Index>& held) {
  const Solid<d> solid = testing::elastic_body<d>({}, LawChoice("neo-hookean"), 0, 0, 3);
  DiscreteEnergy<d> energy = testing::energy_of_all(solid);
  energy.linearise_at(VectorXd::Zero(d * solid.cloud.size()));
  const auto loose = loose_part(energy, held);
  if (!loose) return std::nullopt;
  EXPECT_FALSE(loose->particle);
  return loose->motion;
}

TEST(RigidMotion, IsNamed) {
  // 2D: 4 x 3 particles on [0, 1] x [0, 2/3]; the first is (0, 0), the last (1, 2/3)
  EXPECT_EQ(freedom<2>({}), "move along x");
  EXPECT_EQ(freedom<2>({0, 2}), "move along y");
  EXPECT_EQ(freedom<2>({0, 1}), "turn about (0, 0)");
  EXPECT_EQ(freedom<2>({22, 23}), "turn about (1, 0.666667)");
  EXPECT_EQ(freedom<2>({0, 1, 23}), std::nullopt);
}

/// A plane held along its normal and one particle held still: the body still turns about that normal.
TEST(RigidMotion, InSpaceATurnAboutAnAxisIsNamedWithItsDirection) {
  const Solid<3> solid = testing::elastic_body<3>({}, LawChoice("neo-hookean"), 0, 0, 3);
  std::vector<Index> held;
  for (const Index i : particles_on_face(solid.cloud, 0, false, Layout::node)) held.push_back(3 * i);
  const Index still = held.front() / 3;
  held.insert(held.end(), {3 * still + 1, 3 * still + 2});
  const auto motion = freedom<3>(held);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->find("turn about the direction (1, 0, 0)") == 0 ||
              motion->find("turn about the direction (-1, 0, 0)") == 0)
      << *motion;
  const Index other = held[3] / 3;
  held.push_back(3 * other + 1);
  held.push_back(3 * other + 2);
  EXPECT_EQ(freedom<3>(held), std::nullopt);
}

/// Rollers of a mirror layout hold by images, not by held unknowns.
TEST(RigidMotion, ImagesResistIt) {
  Cloud<2> cloud = testing::block<2>(4, Layout::mirror, 0);
  BondOptions<2> options = testing::options<2>({}, cloud.spacing);
  options.walls = {{0, false}};
  const Solid<2> solid = make_solid<2>(std::move(cloud), "neo-hookean", testing::rubber, options);
  DiscreteEnergy<2> energy = testing::energy_of_all(solid);
  energy.linearise_at(VectorXd::Zero(2 * solid.cloud.size()));
  EXPECT_EQ(loose_part(energy, {}).value().motion, "move along y");
  EXPECT_FALSE(loose_part(energy, {1}));
}

}  // namespace
}  // namespace plumb
