// Laws of the discrete energy: its residual and tangent are its first and second derivatives, for every law,
// table and term; momenta.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/geometry/rigid_motions.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"
#include "tests/lib/schemes/tangent_checks.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

template <class Case>
class ImplicitLaws : public ::testing::Test {};
using Bodies = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(ImplicitLaws, Bodies, test::Names);

template <int d>
void tangent_is_the_derivative(const Solid<d>& solid, const std::string& what) {
  testing::tangent_is_the_derivative<d>(testing::energy_of_all(solid),
                                        testing::smooth_motion(solid.cloud, 0.05), what);
}

TYPED_TEST(ImplicitLaws, TangentIsTheDerivativeOfResidualAndEnergyForEveryLaw) {
  constexpr int d = TypeParam::d;
  for (const LawChoice& law : testing::elastic_laws(d))
    tangent_is_the_derivative<d>(testing::elastic_body<d>({}, law, 0, 0.2),
                                 law.name + (law.plane == Plane::stress ? ", plane stress" : ""));
}

TYPED_TEST(ImplicitLaws, TangentIsTheDerivativeOfResidualAndEnergyForEveryTableAndTerm) {
  constexpr int d = TypeParam::d;
  for (const auto& table : testing::all_tables())
    for (const double alpha : {0.0, 0.7})
      for (const double jitter : {0.0, 0.2})
        tangent_is_the_derivative<d>(
            testing::elastic_body<d>(table, LawChoice("neo-hookean"), alpha, jitter),
            table.name + " alpha " + std::to_string(alpha) + " jitter " + std::to_string(jitter));
}

TYPED_TEST(ImplicitLaws, TangentIsTheDerivativeForEveryTableBesideWeightsOfTheSlope) {
  constexpr int d = TypeParam::d;
  for (const auto& table : testing::all_tables())
    for (const double jitter : {0.0, 0.2})
      tangent_is_the_derivative<d>(
          testing::elastic_body<d>(table, LawChoice("neo-hookean"), 0.7, jitter, d == 2 ? 6 : 4, "slope"),
          table.name + " slope, jitter " + std::to_string(jitter));
}

TYPED_TEST(ImplicitLaws, ImagesBehindWallsAreInTheTangent) {
  constexpr int d = TypeParam::d;
  Cloud<d> cloud = testing::block<d>(4, Layout::mirror, 0);
  BondOptions<d> options = testing::options<d>({}, cloud.spacing);
  options.walls = {{0, false}, {1, true}};
  tangent_is_the_derivative<d>(make_solid<d>(std::move(cloud), "neo-hookean", testing::rubber, options),
                               "mirror");
}

/// K of chosen unknowns is that part of the whole K, also after it was moved to another displacement.
TYPED_TEST(ImplicitLaws, ThePartOfTheTangentIsThatPart) {
  constexpr int d = TypeParam::d;
  const Solid<d> solid = testing::elastic_body<d>({"compatible"}, LawChoice("polyconvex"), 0.5, 0.2);
  const std::vector<Index> chosen = free_unknowns(d * solid.cloud.size(), {0, 1, 7, 12});
  DiscreteEnergy<d> whole = testing::energy_of_all(solid), part(solid, chosen);
  for (const double size : {0.0, 0.04}) {
    const VectorXd u = testing::smooth_motion(solid.cloud, size);
    whole.linearise_at(u);
    part.linearise_at(u);
    const SparseMatrix K = part_of(whole.tangent(), chosen, chosen);
    EXPECT_LT((part.tangent() - K).norm(), 1e-15 * K.norm()) << size;
  }
}

TYPED_TEST(ImplicitLaws, RigidMotionsCostNothingAtTheReference) {
  constexpr int d = TypeParam::d;
  for (const auto& table : testing::all_tables()) {
    if (table.name == "bond38") continue;  // it does not reproduce affine motion
    const Solid<d> solid =
        testing::elastic_body<d>(table, LawChoice("neo-hookean"), 0.7, 0.2, d == 2 ? 6 : 4,
                                 table.name == "dual" || table.name == "compatible" ? "slope" : "kernel");
    DiscreteEnergy<d> energy = testing::energy_of_all(solid);
    energy.linearise_at(VectorXd::Zero(d * solid.cloud.size()));
    const SparseMatrix K = energy.tangent();
    Eigen::MatrixXd motions(K.rows(), d * (d + 1) / 2);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      motions.middleRows<d>(d * i) = RigidMotions<d>(solid.cloud.box).at(solid.cloud.X[i]);
    EXPECT_LT((K * motions).norm(), 1e-13 * K.norm() * motions.norm()) << table.name;
  }
}

TYPED_TEST(ImplicitLaws, InternalForcesHaveNeitherSumNorTorque) {
  constexpr int d = TypeParam::d;
  for (const auto& table : testing::all_tables())
    for (const char* law : {"neo-hookean", "saint-venant-kirchhoff", "polyconvex"}) {
      const Solid<d> solid =
          testing::elastic_body<d>(table, LawChoice(law), 0.7, 0.2, d == 2 ? 6 : 4,
                                   table.name == "dual" || table.name == "compatible" ? "slope" : "kernel");
      DiscreteEnergy<d> energy = testing::energy_of_all(solid);
      const VectorXd u = testing::smooth_motion(solid.cloud, 0.05), r = energy.residual(u).value();
      Vec<d> sum = Vec<d>::Zero();
      Mat<d> torque = Mat<d>::Zero();
      double size = 0;
      for (Index i = 0; i < solid.cloud.size(); ++i) {
        const Vec<d> f = r.template segment<d>(d * i), x = solid.cloud.X[i] + u.template segment<d>(d * i);
        sum += f;
        torque += x * f.transpose() - f * x.transpose();
        size += f.norm();
      }
      EXPECT_LT(sum.norm(), 1e-13 * size) << table.name << law;     // sums of some hundred terms
      EXPECT_LT(torque.norm(), 1e-13 * size) << table.name << law;  // positions are of order 1 m
    }
}

TYPED_TEST(ImplicitLaws, AForceWithoutEnergyIsRefused) {
  constexpr int d = TypeParam::d;
  Cloud<d> cloud = testing::block<d>(5, Layout::node, 0.2);
  const BondOptions<d> options = testing::options<d>({.momentum = "symmetrised"}, cloud.spacing);
  const Solid<d> solid = make_solid<d>(std::move(cloud), "neo-hookean", testing::rubber, options);
  EXPECT_THROW(testing::energy_of_all(solid), InputError);
}

TEST(DiscreteEnergy, ATurnedOverParticleHasNoResidual) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0);
  DiscreteEnergy<2> energy = testing::energy_of_all(solid);
  VectorXd u = VectorXd::Zero(2 * solid.cloud.size());
  for (Index i = 0; i < solid.cloud.size(); ++i) u[2 * i] = -1.5 * solid.cloud.X[i][0];  // J = -0.5
  EXPECT_FALSE(energy.residual(u));
  EXPECT_EQ(energy.trouble().value().particle, 0);
  EXPECT_NEAR(energy.trouble().value().value, -0.5, 1e-12);
}

TEST(DiscreteEnergy, LeavesTheStateOfItsBodyAlone) {
  const Solid<2> solid = testing::elastic_body<2>({}, LawChoice("neo-hookean"), 0, 0);
  State<2> state = make_state(solid);
  const VectorXd u = testing::smooth_motion(solid.cloud, 0.02);
  set_unknowns(solid, u, state.u);
  EXPECT_EQ(unknowns_of(solid, state.u), u);
}

}  // namespace
}  // namespace plumb
