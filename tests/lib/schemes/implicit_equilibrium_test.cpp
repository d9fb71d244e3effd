// Equilibria against exact ones: patch tests under dead loads and pressures, quadratic convergence, supports
// that move, and what is said when there is no equilibrium.
#include "lib/schemes/implicit/equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/core/error.hpp"
#include "lib/input/scene_error.hpp"
#include "lib/material/models/neo_hookean.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/element/element.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/parts/hourglass.hpp"
#include "tests/support/mixed.hpp"
#include "tests/support/solids.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

Scene block_scene(const std::string& more, const std::string& size = "[1, 0.6]",
                  const std::string& body = "") {
  const std::string dimension = size.find(',') == size.rfind(',') ? "2" : "3";
  return parse_scene("[scene]\ndimension = " + dimension + "\nend_time = \"2 s\"\n[body]\nsize = " + size +
                         "\nspacing = 0.2\nlayout = \"node\"\njitter = 0.2\n" + body + R"(
[material]
model = "neo-hookean"
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
gradient = "compatible"
beta = 1.2
)" + more,
                     "block.toml");
}

const std::string rollers = R"([[boundary]]
face = "x-"
kind = "roller"
[[boundary]]
face = "y-"
kind = "roller"
)";
const std::string rollers_in_space = rollers + "[[boundary]]\nface = \"z-\"\nkind = \"roller\"\n";

template <int d>
StaticResult<d> found(TlsphBody<d>& s, const ImplicitOptions& options = {}, const OnLoadStep& on_step = {}) {
  return find_equilibrium<d>(s.solid, s.actions, s.control.end_time.value(), options, s.state, on_step);
}

/// Every particle has the same deformation gradient, to the tolerance of Newton's method.
template <int d>
Mat<d> common_gradient(const TlsphBody<d>& s) {
  const Mat<d> F = deformation_gradient_of(s.solid, s.state, 0);
  for (Index i = 1; i < s.solid.cloud.size(); ++i)
    EXPECT_LT((deformation_gradient_of(s.solid, s.state, i) - F).norm(), 1e-8) << i;
  return F;
}

/// P of the law at F, by the body's own loops: differences of its energy would do, the tangent's integral is
/// exact enough.
template <int d>
Mat<d> stress_at(const TlsphBody<d>& s, const Mat<d>& F) {
  const NeoHookean law(s.solid.elastic);
  return law.first_piola(F);
}

/// Traction on the end of a bar on rollers: a uniform stretch with P N = traction, whatever the cloud.
TEST(Equilibrium, DeadTractionPassesThePatchTest) {
  auto s = make_tlsph<2>(
      block_scene(rollers + "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"8 MPa\", 0]\n"));
  const auto result = found(s);
  ASSERT_TRUE(result.completed());
  const Mat<2> F = common_gradient(s), P = stress_at(s, F);
  EXPECT_GT(F(0, 0), 1.3);  // far from small strain
  EXPECT_NEAR(P(0, 0), 8e6, 1e-8 * 8e6);
  EXPECT_NEAR(P(1, 1), 0, 1e-8 * 8e6);
  // reactions: the roller on x- carries the resultant, 8 MPa on 0.6 m
  ASSERT_EQ(result.reactions.size(), 2u);
  EXPECT_EQ(result.reactions[0].boundary, "x-");
  EXPECT_NEAR(result.reactions[0].force[0], -8e6 * 0.6, 1e-8 * 8e6);
  EXPECT_NEAR(result.reactions[1].force[1], 0, 1e-8 * 8e6);
  EXPECT_EQ(s.state.time, 2.0);
}

TEST(Equilibrium, PressureThatFollowsPassesThePatchTestInSpace) {
  std::string loads;
  for (const char* face : {"x+", "y+", "z+"})
    loads +=
        std::string("[[boundary]]\nface = \"") + face + "\"\nkind = \"pressure\"\npressure = \"9 MPa\"\n";
  auto s = make_tlsph<3>(block_scene(rollers_in_space + loads, "[0.8, 0.6, 0.6]"));
  const auto result = found(s);
  ASSERT_TRUE(result.completed());
  const Mat<3> F = common_gradient(s);
  const double J = F.determinant();
  EXPECT_LT(J, 0.8);  // kappa = 14.2 MPa
  const Mat<3> cauchy = stress_at(s, F) * F.transpose() / J;
  EXPECT_LT((cauchy + 9e6 * Mat<3>::Identity()).norm(), 1e-7 * 9e6);
}

/// |r_next| = C |r|^2 near the root: ln|r_next|/ln|r| goes to 2. Judged by residuals that are small enough
/// for C not to matter much, and above round-off of the forces.
void expect_quadratic(const std::vector<double>& r) {
  int judged = 0;
  for (std::size_t n = 0; n + 1 < r.size(); ++n) {
    if (r[n] > 0.03 || r[n + 1] < 1e-13) continue;
    EXPECT_GT(std::log(r[n + 1]) / std::log(r[n]), 1.7) << r[n] << " " << r[n + 1];
    ++judged;
  }
  EXPECT_GE(judged, 2);
}

TEST(Equilibrium, NewtonConvergesQuadratically) {
  for (const char* kind : {"kind = \"traction\"\ntraction = [0, \"0.3 MPa\"]\n",
                           "kind = \"pressure\"\npressure = \"4 MPa\"\n"}) {
    auto s = make_tlsph<2>(block_scene(
        "[hourglass]\n[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n[[boundary]]\nface = \"x+\"\n" +
        std::string(kind)));
    ImplicitOptions options;
    options.steps = 1;
    options.tolerance = 1e-13;
    const auto result = found(s, options);
    ASSERT_TRUE(result.completed());
    ASSERT_EQ(result.steps.size(), 1u);
    EXPECT_EQ(result.steps[0].newton.shifted, 0);
    expect_quadratic(result.steps[0].newton.residuals);
  }
}

/// Half of the length in one step: the predictor carries the interior along, and the ends are where they are
/// told to be.
TEST(Equilibrium, SupportsThatMoveTakeTheBodyAlong) {
  auto s = make_tlsph<2>(block_scene(
      rollers + "[[boundary]]\nface = \"x+\"\nkind = \"displacement\"\ndisplacement = [\"0.25*t\", 0]\n"));
  ImplicitOptions options;
  options.steps = 1;
  const auto result = found(s, options);
  ASSERT_TRUE(result.completed());
  EXPECT_EQ(result.rejected, 0);
  for (Index i = 0; i < s.solid.cloud.size(); ++i)
    if (s.solid.cloud.X[i][0] > 0.99) {
      const Vec<2> u = vector_at<2>(s.state.u, s.solid.bonds.slots.of(i));
      EXPECT_EQ(u[0], 0.5);
      EXPECT_EQ(u[1], 0);
    }
  EXPECT_NEAR(result.reactions[0].force[0], -result.reactions[2].force[0],
              1e-7 * result.reactions[2].force[0]);
  EXPECT_GT(result.reactions[2].force[0], 0.6 * 17e6 * 0.3);
}

/// Pushed in by more than a spacing in one step: alone, the first layer would pass through the second.
TEST(Equilibrium, SupportsThatMoveDoNotTearTheirFirstLayerOff) {
  auto s = make_tlsph<2>(block_scene(
      rollers + "[[boundary]]\nface = \"x+\"\nkind = \"displacement\"\ndisplacement = [\"-0.15*t\", 0]\n"));
  ImplicitOptions options;
  options.steps = 1;
  options.adaptive = false;
  EXPECT_TRUE(found(s, options).completed());
}

/// Hooke's answer to -30 MPa is a strain of -1.3: backtracking keeps J positive, and finds the equilibrium in
/// one load step.
TEST(Equilibrium, StepsThatWouldInvertTheBodyAreShortened) {
  auto s = make_tlsph<2>(block_scene(rollers +
                                     "[[boundary]]\nface = \"y+\"\nkind = \"roller\"\n[[boundary]]\nface = "
                                     "\"x+\"\nkind = \"traction\"\ntraction = [\"-30 MPa\", 0]\n"));
  ImplicitOptions options;
  options.steps = 1;
  options.adaptive = false;
  const auto result = found(s, options);
  ASSERT_TRUE(result.completed());
  EXPECT_NEAR(result.reactions[0].force[0], 30e6 * 0.6, 1e-7 * 30e6);
}

/// A corner that two boundaries hold counts once: the reactions add up to the load.
TEST(Equilibrium, ReactionsOfBoundariesThatMeetAddUpToTheLoad) {
  auto s =
      make_tlsph<2>(block_scene("[load]\ngravity = [\"100 m/s^2\", \"-300 m/s^2\"]\n[[boundary]]\nface "
                                "= \"x-\"\nkind = \"clamped\"\n[[boundary]]\nface = "
                                "\"y-\"\nkind = \"roller\"\n"));
  const auto result = found(s);
  ASSERT_TRUE(result.completed());
  const Vec<2> sum = result.reactions[0].force + result.reactions[1].force;
  const double mass = 1100 * 0.6;
  EXPECT_NEAR(sum[0], -100 * mass, 1e-7 * 300 * mass);
  EXPECT_NEAR(sum[1], 300 * mass, 1e-7 * 300 * mass);
  EXPECT_GT(result.reactions[1].force[1], 0.2 * 300 * mass);  // both carry
}

/// Steps grow, the answer does not depend on them, and a path goes on from where it was left.
TEST(Equilibrium, DoesNotDependOnTheSteps) {
  const std::string load = rollers +
                           "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"3e6*t\", "
                           "\"2e5*t\"]\n[[boundary]]\nwhere = \"X + Y < 0.01\"\nkind = \"clamped\"\n";
  auto one = make_tlsph<2>(block_scene(load)), many = one, resumed = one;
  ImplicitOptions options;
  options.steps = 1;
  ASSERT_TRUE(found(one, options).completed());
  options.steps = 10;
  std::vector<double> shares;
  const auto result = found<2>(many, options, [&](const BodyMotion& now, const LoadStep& step) {
    EXPECT_NEAR(now.time, 2 * step.share, 1e-15);
    shares.push_back(step.share);
    if (shares.size() == 2) set_motion<2>(resumed.solid.bonds.slots, now, resumed.state);
  });
  ASSERT_TRUE(result.completed());
  EXPECT_LT(shares.size(), 8u);
  EXPECT_NEAR(shares[0], 0.1, 1e-15);
  EXPECT_NEAR(shares[1], 0.25, 1e-15);  // grown by a half
  EXPECT_EQ(shares.back(), 1);
  EXPECT_NEAR(resumed.state.time, 0.5, 1e-15);
  ASSERT_TRUE(found(resumed, options).completed());
  const auto u = unknowns_of(one.solid, one.state.u);
  EXPECT_LT((u - unknowns_of(many.solid, many.state.u)).norm(), 1e-8 * u.norm());
  EXPECT_LT((u - unknowns_of(resumed.solid, resumed.state.u)).norm(), 1e-8 * u.norm());
}

const std::vector<LinearSolver> solvers{LinearSolver::direct, LinearSolver::iterative};

TEST(Equilibrium, ABodyThatCanStillMoveIsNamed) {
  for (const LinearSolver solver : solvers) {
    auto s = make_tlsph<2>(block_scene("[[boundary]]\nface = \"x-\"\nkind = \"roller\"\n"));
    ImplicitOptions options;
    options.solver = solver;
    try {
      found(s, options);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(), "the body can move along y");
    }
  }
}

/// A block that is held where `held` says, and beside it another piece, five lengths away.
InputError error_of_pieces(std::vector<Vec<2>> piece, const std::vector<Support<2>>& more,
                           LinearSolver solver, double alpha) {
  Cloud<2> cloud = testing::block<2>(4, Layout::node, 0);
  const Index block = cloud.size();
  for (const Vec<2>& X : piece) {
    cloud.X.push_back(X + Vec<2>(5, 0));
    cloud.V.push_back(cloud.V[0]);
  }
  cloud.line = 0;
  const BondOptions<2> options = testing::options<2>({}, cloud.spacing);
  Solid<2> solid = make_solid<2>(std::move(cloud), "neo-hookean", testing::rubber, options);
  if (alpha > 0) add_term(solid, hourglass_term(solid, options.kernel, alpha));
  std::vector<Support<2>> supports;
  for (Index i = 0; i < block; ++i)
    for (int k = 0; k < 2; ++k) supports.push_back({i, k});
  for (const Support<2>& support : more) supports.push_back({block + support.particle, support.component});
  State<2> state = make_state(solid);
  ImplicitOptions how;
  how.solver = solver;
  try {
    find_equilibrium<2>(solid, holding<2>(solid.cloud, supports), 1, how, state);
  } catch (const InputError& error) {
    return error;
  }
  return InputError("nothing is wrong", "", "");
}

/// Two pieces in one cloud, one of them held: no rigid motion of the whole, and yet no equilibrium. It is named by a particle of the
/// piece, and by the motion that is left to it.
TEST(Equilibrium, APieceThatNothingHoldsIsNamedByOneOfItsParticles) {
  const Cloud<2> block = testing::block<2>(4, Layout::node, 0);
  const Index half = block.size();
  for (const LinearSolver solver : solvers)
    for (const double alpha : {0.0, 1.0}) {
      const auto problem = [&](const std::vector<Support<2>>& more) {
        return error_of_pieces(block.X, more, solver, alpha).problem();
      };
      const std::string particle = "particle " + std::to_string(half) + " at (5, 0) can ";
      EXPECT_EQ(problem({}), particle + "move along x with all that hangs on it");
      EXPECT_EQ(problem({{1, 0}, {0, 0}}), particle + "move along y with all that hangs on it");
      EXPECT_EQ(problem({{0, 0}, {0, 1}}), particle + "turn about (5, 0) with all that hangs on it");
      EXPECT_EQ(problem({{0, 0}, {0, 1}, {1, 1}}), "nothing is wrong");
    }
}

/// Two particles that have only each other: along their line they resist, across it they do not, and no table can be made of them.
/// A particle without any neighbour is refused in the same way, by its number and its place.
TEST(Equilibrium, ParticlesWithFewerNeighboursThanDimensionsAreNamed) {
  for (const LinearSolver solver : solvers)
    for (const std::size_t count : {1u, 2u}) {
      const std::vector<Vec<2>> piece{{0, 0}, {0.2, 0}};
      try {
        error_of_pieces({piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count)}, {}, solver, 0);
        FAIL();
      } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("particle 20"), std::string::npos) << error.what();
        EXPECT_NE(error.what(), nullptr);
      }
    }
}

/// Cells with one point and without hourglass energy: their two motions without a force are no rigid ones, and three held components
/// leave them. Factors show it before the search, conjugate gradients where they do not end.
TEST(Equilibrium, AParticleThatMovesWithoutAForceIsNamed) {
  ElementOptions reduced;
  reduced.order = "reduced";
  reduced.alpha = 0;
  const Cloud<2> cloud = testing::nodes<2>(Vec<2>::Zero(), Vec<2>(1, 1), {4, 4});
  for (const LinearSolver solver : solvers) {
    Actions<2> actions = holding<2>(cloud, {{0, 0}, {0, 1}, {4, 1}});
    actions.body_forces.push_back({"load", [](const Vec<2>& X, double) -> Vec<2> {
                                     return {1e4 * std::sin(9 * X[0] + 5 * X[1]), 0};
                                   }});
    const Element<2> body({cloud, LawChoice("neo-hookean"), testing::rubber}, reduced, actions);
    ImplicitOptions options;
    options.solver = solver;
    BodyMotion motion{VectorXd::Zero(2 * cloud.size()), VectorXd::Zero(2 * cloud.size()), 0, 0};
    std::string said;
    try {
      const auto result = find_equilibrium<2>(body.stored_energy(), actions, 1, options, motion);
      ASSERT_FALSE(result.completed());
      said = result.failure->in_words();
      EXPECT_EQ(result.rejected, 0);
    } catch (const InputError& error) {
      said = error.problem();
    }
    const bool factors = solver == LinearSolver::direct;
    EXPECT_NE(said.find(factors ? "can move without a force" : "conjugate gradients do not end; particle "),
              std::string::npos)
        << said;
  }
}

/// Saint Venant-Kirchhoff under a dead pressing load: P = E (l^3 - l)/2 is least at l = 1/sqrt(3), with P =
/// -E/(3 sqrt(3)) (nu = 0).
TEST(Equilibrium, StopsBelowALimitPointAndSaysSo) {
  auto scene =
      block_scene(rollers +
                  "[[boundary]]\nface = \"y+\"\nkind = \"roller\"\n[[boundary]]\nface = \"x+\"\nkind = "
                  "\"traction\"\ntraction = [\"-4 MPa\", 0]\n");
  scene.material.model = "saint-venant-kirchhoff";
  scene.material.poisson = 0;
  auto s = make_tlsph<2>(scene);
  const auto result = found(s);
  ASSERT_FALSE(result.completed());
  EXPECT_EQ(result.failure->cause, "limit-point") << result.failure->in_words();
  const double limit = 17e6 / (3 * std::sqrt(3.0)) / 4e6;  // 0.818 of the load
  EXPECT_LT(s.state.time / 2, limit);
  EXPECT_GT(s.state.time / 2, 0.99 * limit);
  EXPECT_GT(result.failure->share, s.state.time / 2);
  const double stretch = common_gradient(s)(0, 0);
  EXPECT_GT(stretch, 1 / std::sqrt(3.0));
  EXPECT_NEAR(17e6 * (std::pow(stretch, 3) - stretch) / 2, -4e6 * s.state.time / 2, 1e-6 * 4e6);
}

/// The block with a force that is no number from t = 0.9 s on.
TlsphBody<2> lost_block() {
  auto s = make_tlsph<2>(block_scene(rollers));
  s.actions.body_forces.push_back({"lost",
                                   [](const Vec<2>&, double t) -> Vec<2> {
                                     return {1e5 * std::sqrt(0.9 - t), 0};
                                   },
                                   false});
  return s;
}

TEST(Equilibrium, ALoadThatIsNotANumberIsSaid) {
  auto s = lost_block();
  const auto result = found(s);
  ASSERT_FALSE(result.completed());
  EXPECT_EQ(result.failure->cause, "non-finite");
  EXPECT_LT(s.state.time, 0.9);
  EXPECT_GT(s.state.time, 0.89);
  EXPECT_GT(result.rejected, 0);
}

TEST(Equilibrium, WithoutAdaptationAFailedStepEndsThePath) {
  auto s = lost_block();
  ImplicitOptions options;
  options.adaptive = false;
  const auto result = found(s, options);
  EXPECT_EQ(result.rejected, 0);
  EXPECT_EQ(result.steps.size(), 1u);
  EXPECT_EQ(s.state.time, 0.5);
  EXPECT_EQ(result.failure->share, 0.5);
}

/// A wall that goes through the body: the last equilibrium is kept, and the particle whose J is not positive
/// is named.
TEST(Equilibrium, ATurnedOverParticleIsNamed) {
  auto s = make_tlsph<2>(block_scene(rollers +
                                     "[[boundary]]\nface = \"y+\"\nkind = \"roller\"\n[[boundary]]\nface = "
                                     "\"x+\"\nkind = \"displacement\"\ndisplacement = [\"-0.7*t\", 0]\n"));
  const auto result = found(s);
  ASSERT_FALSE(result.completed());
  EXPECT_EQ(result.failure->cause, "inverted");
  EXPECT_LE(result.failure->trouble.value().value, 0);
  EXPECT_GE(result.failure->trouble.value().particle, 0);
  EXPECT_NE(result.failure->in_words().find("J = "), std::string::npos);
  EXPECT_LT(s.state.time / 2, 1 / 1.4);
  EXPECT_GT(s.state.time / 2, 0.9 / 1.4);
  EXPECT_GT(common_gradient(s)(0, 0), 0);
}

}  // namespace
}  // namespace plumb
