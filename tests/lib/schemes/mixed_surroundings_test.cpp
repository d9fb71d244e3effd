// The scheme of paper 003 with compatible bonds, the projection of its section 6, walls, and graded clouds.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

MixedOptions printed_scheme() {
  MixedOptions o = mixed_options("reconstructed", "evolved");
  o.volumes = "tributary";
  return o;
}

/// Relative change of angular momentum of a free square that spins at 50 rad/s for .05 s.
double change_of_spin(const MixedOptions& options) {
  Mixed<2> body = mixed_body(cube<2>(6), options);
  MixedState<2> state = body.start({{}, spinning(body.cloud().X, 50)});
  const double before = spin_of(body.snapshot(state));
  EXPECT_TRUE(run_to(body, state, 0.05));
  return std::abs(spin_of(body.snapshot(state)) - before) / before;
}

TEST(MixedProjection, KeepsAngularMomentumOfThePrintedSchemeToRoundOff) {
  MixedOptions o = printed_scheme();
  EXPECT_GT(change_of_spin(o), 1e-4);
  o.projects = true;
  EXPECT_LT(change_of_spin(o), 1e-12);  // of some hundred stages
  o.smooth_positions = true;            // which scenes refuse: its points do not move with the velocity
  EXPECT_GT(change_of_spin(o), 1e-8);
}

MixedOptions compatible_bonds(double list) {
  MixedOptions o;
  o.gradient = "compatible";
  o.list = list;
  return o;
}

/// Largest error of F, and of the acceleration by a uniform stress against the surface's, in an affine motion of a jittered body.
template <int d>
double affine_error(const MixedOptions& options) {
  const Cloud<d> cloud = jittered<d>(cube<d>(5), 0.2, 5, Layout::node);
  Mat<d> A = Mat<d>::Identity();
  A(0, 1) = 0.2;
  A(1, 1) = 1.1;
  InitialMotion<d> motion;
  for (const Vec<d>& X : cloud.X) motion.u.push_back((A - Mat<d>::Identity()) * X);
  Mixed<d> body = mixed_body(cloud, options);
  const MixedState<d> state = body.start(motion);
  MixedState<d> rate = state;
  EXPECT_FALSE(body.rates(state, 0, rate));
  const double scale = column_rubber.young / column_rubber.density / cloud.spacing;
  double most = 0;
  const Snapshot<d> s = body.snapshot(state);
  for (Index p = 0; p < cloud.size(); ++p) {
    most = std::max(most, (s.F[p].template topLeftCorner<d, d>() - A).norm());
    if (cloud.X[p].cwiseAbs().maxCoeff() < 0.25)  // no bond of it reaches the surface
      most = std::max(most, vector_at<d>(rate.v, body.bonds().table.slots.of(p)).norm() / scale);
  }
  return most;
}

TEST(MixedCompatible, AffineMotionAndUniformStressAreExactOnClouds) {
  EXPECT_LT(affine_error<2>(compatible_bonds(2.4)), 1e-11);  // the projection's 1e-12 and its sums
  EXPECT_LT(affine_error<3>(compatible_bonds(2.4)), 1e-11);
  EXPECT_GT(affine_error<2>(MixedOptions()), 1e-3);  // a uniform stress leaves a force with kernel sums
}

TEST(MixedCompatible, KeepsMomentaAndTakesEnergy) {
  const Cloud<2> cloud = jittered<2>(cube<2>(6), 0.2, 5, Layout::node);
  MixedOptions o = compatible_bonds(2.4);
  o.cfl = 0.4;
  Mixed<2> body = mixed_body(cloud, o);
  MixedState<2> state = body.start(rough_motion(cloud, 0.05, 5));
  const double E0 = body.energy(state).total();
  double E = E0, most = -1;
  ASSERT_TRUE(run_to(body, state, 5e-3, [&] {
    const double now = body.energy(state).total();
    most = std::max(most, (now - E) / E0);
    E = now;
  }));
  EXPECT_LE(most, 1e-14);
  EXPECT_LT(E, 0.8 * E0);
}

TEST(MixedCompatible, GoesWithNoUpdateOfTheReference) {
  MixedOptions o = compatible_bonds(1.75);
  EXPECT_NE(o.in_words().find("compatible bonds"), std::string::npos);
  const Mixed<2> body = mixed_body(cube<2>(4), o);
  EXPECT_NE(body.account()[0].text.find("compatible bonds"), std::string::npos);
  EXPECT_EQ(body.account()[1].theory, "THEORY (11.4)");
}

/// A square that flies at 5 m/s onto the plane y = -0.6.
Mixed<2> falling_square() {
  RigidWall<2> wall;
  wall.name = "floor";
  wall.beside = half_space<2>(Vec<2>(0, -0.6), Vec<2>(0, 1));
  wall.modulus = column_rubber.young;
  return Mixed<2>({cube<2>(5), LawChoice("polyconvex"), column_rubber}, MixedOptions(), {}, 0, {wall});
}

TEST(MixedWalls, ABodyMeetsAWallAndLeavesItAgain) {
  Mixed<2> body = falling_square();
  MixedState<2> state = body.start({{}, std::vector<Vec<2>>(body.cloud().X.size(), Vec<2>(0, -5))});
  EXPECT_LE(body.step_limit(state), body.outside().contact().step_limit());
  double pressed = 0, along = 0, lowest = 0;
  const double E0 = body.energy(state).total();
  ASSERT_TRUE(run_to(body, state, 0.1, [&] {
    pressed = std::max(pressed, body.outside().contact().force(0)[1]);
    along = std::max(along, std::abs(body.outside().contact().force(0)[0]));
    for (const Vec<2>& x : body.snapshot(state).x) lowest = std::min(lowest, x[1]);
  }));
  EXPECT_GT(pressed, 0);
  EXPECT_EQ(along, 0);  // it is smooth
  EXPECT_LT(lowest, -0.6);
  EXPECT_GT(lowest, -0.65);  // a fraction of a spacing, at the stiffness of the body
  const Snapshot<2> s = body.snapshot(state);
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    EXPECT_GT(s.x[i][1], -0.6);
    momentum += s.mass[i] * s.v[i][1];
    mass += s.mass[i];
  }
  EXPECT_GT(momentum / mass, 3);                               // it has been thrown back
  EXPECT_LT(body.energy(state).total(), E0);                   // by upwinding
  EXPECT_EQ(body.outside().contact().force(0), Vec<2>(0, 0));  // and nothing holds it
}

TEST(MixedWarnings, OneSearchRadiusForAGradedCloud) {
  const auto warned = [](Cloud<2> cloud) {
    for (const std::string& warning : mixed_body(std::move(cloud), MixedOptions()).warnings())
      if (warning.find("graded cloud: particles have up to") != std::string::npos) return true;
    return false;
  };
  EXPECT_FALSE(warned(cube<2>(8)));
  EXPECT_FALSE(warned(jittered<2>(cube<2>(8), 0.2, 5, Layout::node)));
  Cloud<2> graded = cube<2>(8);  // layers of 1 : 3
  for (Vec<2>& X : graded.X) X[1] = X[1] < 0 ? X[1] : X[1] / 3;
  graded.line = 0;
  EXPECT_TRUE(warned(graded));
}

}  // namespace
}  // namespace plumb::testing
