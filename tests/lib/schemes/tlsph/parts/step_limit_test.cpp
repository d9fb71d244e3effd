// The largest step that the dissipation allows, against the dense matrix of what the term does to velocities.
// THEORY (6.1), (6.5).
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/parts/jst.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

/// Acceleration of every velocity component per velocity of every other [1/s], by the term alone.
template <int d>
Eigen::MatrixXd damping(Solid<d> solid, const JstOptions& options) {
  add_term(solid, jst_term(solid, options));
  const Index n = d * solid.cloud.size();
  Eigen::MatrixXd A(n, n);
  for (Index column = 0; column < n; ++column) {
    State<d> state = make_state(solid);
    state.v[static_cast<int>(column % d)][solid.bonds.slots.of(column / d)] = 1;
    const auto f = forces(solid, state);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      A.template block<d, 1>(d * i, column) = f[i] / solid.elastic.density;
  }
  return A;
}

template <int d>
Solid<d> body(double jitter, bool transpose, bool walls) {
  Cloud<d> cloud = block<d>(d == 2 ? 7 : 5, Layout::cell, jitter);
  auto how = options<d>({"improved", "adjoint", plumb::Correction::W1, 0.9, true}, cloud.spacing);
  how.outer_transpose = transpose;
  if (walls) how.walls = {{0, false}, {1, true}};
  return make_solid<d>(std::move(cloud), "neo-hookean", rubber, how);
}

template <int d>
void expect_limit(double jitter, bool transpose, bool walls) {
  const Solid<d> solid = body<d>(jitter, transpose, walls);
  const JstOptions options{0, 0.125};
  const double most = damping(solid, options).eigenvalues().cwiseAbs().maxCoeff();  // [1/s]
  const double limit = jst_step_limit(solid, options, 2.51);
  // sixty steps of power iteration: up to 1.3 % too small where the two largest eigenvalues are close
  const double near = 0.02;
  EXPECT_NEAR(limit * most, 2.51, near * 2.51)
      << d << "D jitter " << jitter << " transpose " << transpose << " walls " << walls;
  const double C = solid.elastic.wave_speed(), h = solid.smoothing_length, spacing = solid.cloud.spacing;
  EXPECT_NEAR(biharmonic_radius(solid), most / (0.125 * C * h * h * h) * std::pow(spacing, 4),
              near * biharmonic_radius(solid));
}

TEST(JstStepLimit, IsTheStabilityRegionOverTheLargestEigenvalue) {
  for (const double jitter : {0.0, 0.2})
    for (const bool transpose : {false, true})
      for (const bool walls : {false, true}) expect_limit<2>(jitter, transpose, walls);
  expect_limit<3>(0, false, false);
  expect_limit<3>(0.2, true, true);
}

/// A scene takes the region of its own integrator: 2.51 on the negative real axis for RK3, 2 for Verlet.
TEST(JstStepLimit, OfASceneIsThatOfItsIntegrator) {
  const std::string text =
      "[scene]\ndimension = 2\nmax_steps = 1\n[body]\nsize = [1, 1]\nspacing = 0.125\n[material]\nyoung = "
      "17e6\npoisson = 0.45\n"
      "density = 1100\n[method]\nintegrator = \"rk3\"\n[jst]\neta4 = 0.25\n";
  for (const auto& [integrator, region] : {std::pair{"rk3", 2.51}, std::pair{"verlet", 2.0}}) {
    const auto simulation =
        make_tlsph<2>(parse_scene(text, "t.toml", {std::string("method.integrator=") + integrator}));
    const Solid<2>& solid = simulation.solid;
    EXPECT_NEAR(solid.step_limit, jst_step_limit(solid, {0, 0.25}, region), 1e-12 * solid.step_limit)
        << integrator;
    EXPECT_NEAR(jst_step_limit(solid, {0, 0.125}, region), 2 * solid.step_limit, 1e-12 * solid.step_limit);
  }
}

}  // namespace
}  // namespace plumb::testing
