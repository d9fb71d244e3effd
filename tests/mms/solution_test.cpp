#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mms/manufactured.hpp"
#include "mms/solution.hpp"

namespace plumb::mms::solution_test {
namespace {

const Elastic rubber{17e6, 0.495, 1100};

// omega and period computed by hand from the paper's data.
TEST(SwingingPlate, PeriodAndAmplitude) {
  const Manufactured<2> plate = manufactured<2>("swinging-plate", {{"amplitude", 0.02}}, rubber);
  EXPECT_NEAR(2 * pi / plate.period, 159.708, 5e-4);
  const Vec<2> u = plate.displacement({1, 0}, plate.period / 4);
  EXPECT_NEAR(u[0], -0.02, 1e-16);
  EXPECT_NEAR(u[1], 0, 1e-16);
}

// The field solves linear elasticity: what is left for the body force is of second order in U.
TEST(SwingingPlate, BodyForceIsOfSecondOrderInTheAmplitude) {
  const Vec<2> X(0.3, 0.8);
  const auto force = [&](double amplitude) {
    const Manufactured<2> plate = manufactured<2>("swinging-plate", {{"amplitude", amplitude}}, rubber);
    return plate.body_force(X, plate.period / 7).norm();
  };
  EXPECT_NEAR(force(2e-4) / force(1e-4), 4, 0.01);  // third-order terms are 1e-4 of it
}

// Every face condition of the catalogue that says "free" or "roller" must be true of the field, for a
// material that the field was not made for.
template <int d>
void expect_box_conditions(const char* name, double tolerance) {
  const Manufactured<d> m = manufactured<d>(name, {}, Elastic{1e6, 0.2, 900});
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int face = 0; face < 2 * d; ++face)
    for (int k = 0; k < 20; ++k) {
      const int axis = face / 2;
      Vec<d> X = m.domain.box.origin;
      for (int a = 0; a < d; ++a) X[a] += m.domain.box.size[a] * (a == axis ? face % 2 : uniform(random));
      const double t = uniform(random) * m.period;
      Vec<d> N = Vec<d>::Zero();
      N[axis] = face % 2 ? 1 : -1;
      Vec<d> traction = m.traction(X, t, N);
      const FaceCondition condition = m.domain.faces[static_cast<std::size_t>(face)];
      ASSERT_EQ(condition.normal, Known::displacement);
      ASSERT_EQ(condition.tangential, Known::traction);
      traction[axis] = 0;
      EXPECT_LT(traction.norm(), tolerance) << name << " face " << face;
    }
}

// sin(pi) = 1e-16 in doubles, times stresses of 1e6 Pa.
TEST(Solutions, RollerFacesCarryNoShear) {
  expect_box_conditions<2>("swinging-plate", 1e-8);
  expect_box_conditions<2>("standing-wave", 1e-8);
  expect_box_conditions<3>("standing-wave", 1e-8);
  expect_box_conditions<3>("trigonometric-cube", 1e-8);
}

// On the circles of the vortex F = I, so that the boundary is free.
TEST(GeneralizedVortex, CirclesAreFreeAndStill) {
  const Manufactured<2> m = manufactured<2>("generalized-vortex", {}, Elastic{1000, 0.3, 1000});
  for (double radius : {0.75, 1.25})
    for (double angle : {0.0, 1.0, 2.5, 4.0}) {
      const Vec<2> N(std::cos(angle), std::sin(angle)), X = radius * N;
      EXPECT_LT(m.traction(X, 0.5, N).norm(), 1e-11);  // stresses inside reach 1e3 Pa
      EXPECT_LT(m.displacement(X, 0.5).norm(), 1e-14);
    }
  const Motion<2> middle = m.motion({1, 0}, 0.5);  // the ring R = 1 has turned by A = 1
  EXPECT_NEAR(middle.displacement[0], std::cos(1.0) - 1, 1e-15);
  EXPECT_NEAR(middle.displacement[1], std::sin(1.0), 1e-15);
  EXPECT_NEAR(m.motion({0.6, 0.7}, 0.37).F.determinant(), 1, 1e-14);  // no change of volume anywhere
}

TEST(AffinePatch, HasNoStressDivergence) {
  const Manufactured<3> m = manufactured<3>("affine-patch", {}, rubber);
  const Motion<3> motion = m.motion({0.2, 0.7, 0.4}, 0.013);
  EXPECT_EQ(m.stress_divergence(motion).norm(), 0);
  EXPECT_GT((motion.F - Mat<3>::Identity()).norm(), 0.3);
}

// P of a rotation is round-off of the bulk modulus (5.7e8 Pa) alone.
TEST(RigidRotation, HasNoStress) {
  const Manufactured<3> m = manufactured<3>("rigid-rotation", {}, rubber);
  const Motion<3> motion = m.motion({0.2, 0.7, 0.4}, 0.013);
  EXPECT_LT(m.first_piola(motion.F).norm(), 1e-6);
  EXPECT_NEAR((motion.F.transpose() * motion.F - Mat<3>::Identity()).norm(), 0, 1e-15);
  EXPECT_NEAR(motion.acceleration.norm(), 105 * 105 * std::hypot(0.3, 0.2), 1e-9);
}

TEST(StretchedColumn, StartsAtRestAndDoublesItsLength) {
  const Manufactured<2> m = manufactured<2>("stretched-column", {}, rubber);
  EXPECT_EQ(m.motion({0.3, 1.2}, 0).velocity.norm(), 0);
  EXPECT_NEAR(m.displacement({0, 2}, m.period / 2)[1], 2, 1e-14);
}

TEST(Solutions, AllStayPermissibleOverTheirWholeParameterRange) {
  for (const SolutionEntry& entry : solution_list()) {
    std::map<std::string, double> most;
    for (const Parameter& p : entry.parameters.all()) most[std::string(p.name)] = p.most;
    const auto check = [&]<int d>(std::integral_constant<int, d>) {
      const Manufactured<d> m = manufactured<d>(entry.name, most, entry.material);
      std::mt19937_64 random(8);
      std::uniform_real_distribution<double> uniform(0, 1);
      for (int k = 0; k < 2000; ++k) {
        Vec<d> X;
        for (int a = 0; a < d; ++a) X[a] = m.domain.box.origin[a] + uniform(random) * m.domain.box.size[a];
        if (!m.domain.contains(X)) continue;
        EXPECT_GT(m.motion(X, uniform(random) * m.period).F.determinant(), 0.05) << entry.name;
      }
    };
    for (int dimension : entry.dimensions) {
      if (dimension == 1) check(std::integral_constant<int, 1>{});
      if (dimension == 2) check(std::integral_constant<int, 2>{});
      if (dimension == 3) check(std::integral_constant<int, 3>{});
    }
  }
}

TEST(Manufactured, BadRequestsAreRefused) {
  EXPECT_THROW(manufactured<2>("swinging-plat", {}, rubber), InputError);
  EXPECT_THROW(manufactured<3>("swinging-plate", {}, rubber), InputError);
  EXPECT_THROW(manufactured<2>("swinging-plate", {{"amplitud", 1e-3}}, rubber), InputError);
  EXPECT_THROW(manufactured<2>("swinging-plate", {{"amplitude", 0.5}}, rubber), InputError);
  EXPECT_THROW(manufactured<2>("swinging-plate", {}, rubber, LawChoice("neo-hooke")), InputError);
}

}  // namespace
}  // namespace plumb::mms::solution_test
