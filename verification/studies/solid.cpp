// Patch tests, the force under uniform stress, and what a run conserves.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <numbers>

#include "lib/schemes/tlsph/boundary/apply_actions.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::solid_study {
using plumb::testing::rubber_block;
using plumb::testing::Scheme;

namespace {

struct CloudKind {
  std::string name;
  Layout layout;
  double jitter;
};
const std::vector<CloudKind> clouds = {{"cell lattice", Layout::cell, 0},
                                       {"node lattice", Layout::node, 0},
                                       {"cell layout, jitter 0.2", Layout::cell, 0.2},
                                       {"node layout, jitter 0.2", Layout::node, 0.2}};

template <int d>
Mat<d> stretched_and_turned() {
  Mat<d> A = Mat<d>::Identity();
  A(0, 0) = 1.3;
  A(0, 1) = 0.4;
  A(1, 0) = -0.2;
  A(1, 1) = 0.9;
  return A;
}

/// Largest error of F on x = A X + b, over all particles.
template <int d>
double affine_error(const CloudKind& kind, const Scheme& scheme) {
  Solid<d> solid = rubber_block<d>(d == 2 ? 12 : 7, kind.layout, kind.jitter, scheme);
  State<d> state = make_state(solid);
  const Mat<d> A = stretched_and_turned<d>();
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i),
                  (A - Mat<d>::Identity()) * solid.cloud.X[i] + Vec<d>::Ones());
  double worst = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    worst = std::max(worst, (deformation_gradient_of(solid, state, i) - A).norm());
  return worst;
}

struct UniformStress {
  double inside = 0,
         boundary =
             0;  ///< largest |force density| x spacing / |P|: zero for a scheme that passes the patch test
};

/// Force of a homogeneously deformed free block, more than two supports from the faces and nearer.
template <int d>
UniformStress uniform_stress_force(const CloudKind& kind, const Scheme& scheme, Index cells) {
  Solid<d> solid = rubber_block<d>(cells, kind.layout, kind.jitter, scheme);
  State<d> state = make_state(solid);
  const Mat<d> A = stretched_and_turned<d>();
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i), (A - Mat<d>::Identity()) * solid.cloud.X[i]);
  Workspace<d> workspace;
  const auto f = plumb::testing::forces(solid, state, workspace);
  double stress = 0;
  for (int a = 0; a < d * d; ++a)
    stress = std::max(stress, std::abs(workspace.P.at(a, solid.bonds.slots.of(solid.cloud.size() - 1))));
  UniformStress result;
  const double rim = 4 * solid.smoothing_length + solid.cloud.spacing;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<d> below = solid.cloud.X[i] - solid.cloud.box.origin;
    const Vec<d> above = solid.cloud.box.size - below;
    double& most = std::min(below.minCoeff(), above.minCoeff()) > rim ? result.inside : result.boundary;
    most = std::max(most, f[i].norm() * solid.cloud.spacing / stress);
  }
  return result;
}

template <int d>
void patch_tests() {
  for (const auto& kind : clouds)
    for (const std::string estimator : {"standard", "improved"})
      for (const Correction pair : {Correction::W1, Correction::W0}) {
        Scheme scheme;
        scheme.estimator = estimator;
        scheme.pair = pair;
        INFO(d << "D " << kind.name << " " << estimator << " " << name_of(pair));
        CHECK(affine_error<d>(kind, scheme) <
              1e-12);  // 30 terms of size 10 x 1e-16 with a margin for the corrections
      }
}

}  // namespace

TEST_CASE("solid: patch test, both estimators give the gradient of affine maps on every cloud",
          "[solid][patch]") {
  patch_tests<2>();
  patch_tests<3>();
}

TEST_CASE("solid: patch test, (38) as printed fails it", "[solid][patch]") {
  Scheme scheme;
  scheme.estimator = "bond38";
  CHECK(affine_error<2>(clouds[0], scheme) > 0.1);  // F_xx = 0.78 on the identity at beta 0.9
}

TEST_CASE("solid: uniform stress leaves no force inside a lattice, and a measured one elsewhere",
          "[solid][patch]") {
  std::cout
      << "force under uniform stress, |f| d / |P|: inside the body, and within two supports of its faces\n";
  for (const auto& kind : clouds)
    for (const std::string momentum : {"symmetrised", "adjoint"}) {
      Scheme scheme;
      scheme.momentum = momentum;
      const auto in_2d = uniform_stress_force<2>(kind, scheme, 24);
      const auto in_3d = uniform_stress_force<3>(kind, scheme, 14);
      std::cout << fmt::format("  {:24} {:12} 2D {:9.2e} {:9.2e}   3D {:9.2e} {:9.2e}\n", kind.name, momentum,
                               in_2d.inside, in_2d.boundary, in_3d.inside, in_3d.boundary);
      INFO(kind.name << " " << momentum);
      if (kind.jitter == 0) {
        CHECK(in_2d.inside < 1e-13);  // sums of 26 antisymmetric weights
        CHECK(in_3d.inside < 1e-13);
      } else {
        // The published forms do not pass on irregular clouds: the measured defect is of the order of one per
        // spacing, at any resolution. This check fails if a scheme that passes is mislabelled.
        CHECK(in_2d.inside > 1e-3);
        CHECK(in_3d.inside > 1e-3);
      }
    }
}

TEST_CASE("solid: linear momentum of a free body is kept to round-off", "[solid][conservation]") {
  for (const auto& kind : clouds)
    for (const std::string momentum : {"symmetrised", "adjoint"}) {
      Scheme scheme;
      scheme.momentum = momentum;
      Solid<3> solid = rubber_block<3>(8, kind.layout, kind.jitter, scheme);
      State<3> state = make_state(solid);
      plumb::testing::deform(solid, state, 0.05);
      const ChosenIntegrator<3> integrator = integrator_named<3>("rk3", solid);
      StepControl control;
      control.cfl = 0.3;
      control.max_steps = 200;
      const RunResult result = run(solid, state, integrator, control);
      INFO(kind.name << " " << momentum);
      REQUIRE(result.completed());
      const Momentum p = momentum_of(solid, state);
      for (const double component : p.linear)
        CHECK(std::abs(component) < 1e-12 * p.linear_scale);  // 600 stages of rounding
    }
}

TEST_CASE("solid: the undamped swinging plate keeps its energy with the adjoint force and Verlet",
          "[solid][conservation]") {
  Box<2> box{Vec<2>(0, 0), Vec<2>(2, 2)};
  const Elastic rubber{17e6, 0.495, 1100};
  Cloud<2> cloud = lattice<2>(box, cells_of<2>(box, 0.1), Layout::node);
  const auto options = plumb::testing::options<2>(Scheme{}, cloud.spacing);
  Solid<2> solid = make_solid<2>(std::move(cloud), "neo-hookean", rubber, options);
  std::vector<Support<2>> supports;
  for (int axis = 0; axis < 2; ++axis)
    for (const bool upper : {false, true})
      for (const Index i : particles_on_face(solid.cloud, axis, upper, Layout::node))
        supports.push_back({i, axis, 0});
  const Actions<2> actions = holding(solid.cloud, supports);
  apply_actions(solid, actions);
  State<2> state = make_state(solid);
  const double q = std::numbers::pi / 2, omega = q * std::sqrt(2 * rubber.shear_modulus() / rubber.density);
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<2>& X = solid.cloud.X[i];
    const Vec<2> v(-std::sin(q * X[0]) * std::cos(q * X[1]), std::cos(q * X[0]) * std::sin(q * X[1]));
    set_vector<2>(state.v, solid.bonds.slots.of(i), Vec<2>(0.01 * omega * v));
  }
  impose(solid, actions, state);
  const double period = 2 * std::numbers::pi / omega;
  const double start = energy_of(solid, state).total();
  const auto worst_drift = [&](double cfl, double periods) {
    State<2> now = state;
    const ChosenIntegrator<2> integrator = integrator_named<2>("verlet", solid);
    StepControl control;
    control.fixed_step = cfl * 0.1 / rubber.wave_speed();
    control.end_time = periods * period;
    double worst = 0;
    const Observer<2> observe = [&](const Solid<2>& body, const State<2>& s) {
      if (s.step % 10 == 0) worst = std::max(worst, std::abs(energy_of(body, s).total() / start - 1));
      return true;
    };
    REQUIRE(run(solid, now, integrator, control, observe).completed());
    return worst;
  };
  const double coarse = worst_drift(0.5, 3), fine = worst_drift(0.25, 3), longer = worst_drift(0.5, 12);
  std::cout << fmt::format(
      "energy of the undamped swinging plate: largest change {:.2e} at cfl 0.5 and {:.2e} at 0.25 in 3 "
      "periods, "
      "{:.2e} at 0.5 in 12\n",
      coarse, fine, longer);
  CHECK(coarse / fine == Approx(4).epsilon(0.15));  // the energy of Verlet oscillates with dt^2
  CHECK(longer < 1.5 * coarse);                     // bounded: no drift
}

}  // namespace plumb::solid_study
