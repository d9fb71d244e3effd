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

/// Largest |J/det F - 1|, and the energy that a rough motion has lost in .01 s.
std::pair<double, double> diffused(bool diffuses) {
  MixedOptions o = mixed_options("adjoint", "evolved");
  o.diffuses_J = diffuses;
  o.cfl = 0.5;
  const Cloud<2> cloud = cube<2>(5);
  Mixed<2> body = mixed_body(cloud, o);
  MixedState<2> state = body.start(rough_motion(cloud, 0.05, 1));
  const double E0 = body.energy(state).total();
  EXPECT_TRUE(run_to(body, state, 0.01));
  double most = 0;
  for (Index p = 0; p < cloud.size(); ++p) {
    const Index i = body.bonds().table.slots.of(p);
    const double det = state.F[0][i] * state.F[3][i] - state.F[1][i] * state.F[2][i];
    most = std::max(most, std::abs(state.J[0][i] / det - 1));
  }
  return {most, 1 - body.energy(state).total() / E0};
}

// J that diffuses is no determinant of F any more, and there is nothing that returns it.
TEST(MixedDiffusion, TakesJAwayFromTheDeterminant) {
  const auto [with, lost] = diffused(true);
  const auto [without, less] = diffused(false);
  EXPECT_GT(with, 100 * without);
  EXPECT_GT(lost, less);
}

// (56), (59), (60) in 1D at rest but for J: V_a dJ_a = sum S^j (Sigma_b - Sigma_a) with S^j = A/(2 rho c_p), A = 1.
TEST(MixedDiffusion, ValueOnAChain) {
  MixedOptions o = mixed_options("none", "evolved");
  o.diffuses_J = true;
  Mixed<1> body = mixed_body(cube<1>(8), o);
  MixedState<1> state = body.start({});
  const Index middle = body.bonds().table.slots.of(4), beside = body.bonds().table.slots.of(3);
  state.J[0][middle] = 1 + 1e-6;
  MixedState<1> rate = state;
  ASSERT_FALSE(body.rates(state, 0, rate));
  // dSigma_J/dJ at rest of the law without share: kappa + (10/9) mu, by J^-2/3 F:F mu/2
  const double slope = column_rubber.bulk_modulus() + 10.0 / 9 * 1.5 * column_rubber.shear_modulus();
  const double d = body.cloud().spacing, S = 1 / (2 * column_rubber.density * column_rubber.wave_speed());
  EXPECT_NEAR(rate.J[0][middle], -2 * S * slope * 1e-6 / d, 1e-5 * 2 * S * slope * 1e-6 / d);
  EXPECT_NEAR(rate.J[0][beside], S * slope * 1e-6 / d, 1e-5 * S * slope * 1e-6 / d);
}

TEST(MixedDiffusion, WarnsWhereALoadActs) {
  MixedOptions o = mixed_options("none", "evolved");
  o.diffuses_J = true;
  const auto warned = [&](const Actions<2>& actions) {
    for (const std::string& warning : mixed_body(cube<2>(3), o, actions).warnings())
      if (warning.find("diffuses_J with loads or walls") != std::string::npos) return true;
    return false;
  };
  Actions<2> weight;
  weight.body_forces.push_back({"weight", [](const Vec<2>&, double) { return Vec<2>(0, -1); }, true});
  EXPECT_FALSE(warned({}));
  EXPECT_TRUE(warned(weight));
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
