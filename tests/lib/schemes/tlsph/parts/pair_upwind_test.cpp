// The dissipation between pairs of a total Lagrangian body, THEORY (16.2), (16.3): what it keeps, what it takes, and the step
// that it bears.
#include "lib/schemes/tlsph/parts/pair_upwind.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

#include "lib/core/in_space.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/measures/budget.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "lib/schemes/upwind.hpp"
#include "tests/support/mixed.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

constexpr double rounding = 1e-12;  // of sums over some hundred particles and 26 neighbours

/// A free block with the tables that a scene may name.
template <int d>
Solid<d> upwind_block(const std::string& gradient, double jitter) {
  Scheme scheme;
  if (gradient != "compatible") scheme.estimator = gradient;
  if (gradient == "compatible") scheme.beta = 1.2;
  Cloud<d> cloud = block<d>(d == 2 ? 8 : 5, Layout::node, jitter);
  auto how = options<d>(scheme, cloud.spacing);
  if (gradient == "compatible") project_compatible(how);
  return make_solid<d>(std::move(cloud), "neo-hookean", rubber, how);
}

/// A deformed state with velocities that no two particles share.
template <int d>
State<d> rough_state(const Solid<d>& solid) {
  State<d> state = make_state(solid);
  deform(solid, state, 0.2);
  Noise noise;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    Vec<d> v;
    for (int k = 0; k < d; ++k) v[k] = 10 * noise();
    set_vector<d>(state.v, solid.bonds.slots.of(i), v);
  }
  return state;
}

/// The force of the term alone per unit volume.
template <int d>
std::vector<Vec<d>> upwind_force(const Solid<d>& solid, State<d>& state) {
  Solid<d> with = solid;
  add_term(with, pair_upwind_term(with));
  std::vector<Vec<d>> f = forces(with, state);
  const std::vector<Vec<d>> without = forces(solid, state);
  for (std::size_t i = 0; i < f.size(); ++i) f[i] -= without[i];
  return f;
}

template <int d>
void keeps_momenta_and_takes_energy(const std::string& gradient, double jitter) {
  SCOPED_TRACE(std::to_string(d) + "D " + gradient + (jitter > 0 ? " jittered" : ""));
  const Solid<d> solid = upwind_block<d>(gradient, jitter);
  State<d> state = rough_state(solid);
  const std::vector<Vec<d>> f = upwind_force(solid, state);
  Vec<d> sum = Vec<d>::Zero();
  Vec<3> torque = Vec<3>::Zero();
  double scale = 0, elastic = 0, power = 0;
  for (const Vec<d>& force : forces(solid, state)) elastic += force.norm();
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const double V = solid.cloud.V[i];
    sum += V * f[i];
    torque += V * in_space<d>(position_of(solid, state, i)).cross(in_space<d>(f[i]));
    scale += V * f[i].norm();
    power += V * f[i].dot(vector_at<d>(state.v, solid.bonds.slots.of(i)));
  }
  // the difference of two forces: of the rounding of the larger one
  const double exact = rounding * (scale + solid.cloud.V[0] * elastic);
  EXPECT_LT(sum.norm(), exact);
  EXPECT_LT(torque.norm(), exact);  // arms are about 1 m
  EXPECT_LT(power, -0.1 * scale);   // of 10 m/s
}

TEST(PairUpwind, KeepsBothMomentaAndTakesEnergy) {
  for (const char* gradient : {"improved", "standard", "compatible"})
    for (const double jitter : {0.0, 0.15}) {
      keeps_momenta_and_takes_energy<2>(gradient, jitter);
      keeps_momenta_and_takes_energy<3>(gradient, jitter);
    }
}

template <int d>
void spares_a_rigid_rotation(const std::string& gradient) {
  const Solid<d> solid = upwind_block<d>(gradient, 0.15);
  State<d> state = rough_state(solid);
  double rough = 0, elastic = 0, turning = 0;
  for (const Vec<d>& force : forces(solid, state)) elastic = std::max(elastic, force.norm());
  for (const Vec<d>& force : upwind_force(solid, state)) rough = std::max(rough, force.norm());
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<3> v = Vec<3>(d == 3 ? 3 : 0, 0, 8).cross(in_space<d>(position_of(solid, state, i)));
    set_vector<d>(state.v, solid.bonds.slots.of(i), v.template head<d>());
  }
  for (const Vec<d>& force : upwind_force(solid, state)) turning = std::max(turning, force.norm());
  EXPECT_LT(turning, rounding * (rough + elastic)) << gradient;
}

TEST(PairUpwind, ARigidRotationOfADeformedBodyCostsNothing) {
  for (const char* gradient : {"improved", "compatible"}) {
    spares_a_rigid_rotation<2>(gradient);
    spares_a_rigid_rotation<3>(gradient);
  }
}

// The scheme of paper 003 with the same bonds has the same forces: pairs, velocity gradients and their transpose.
TEST(PairUpwind, EqualsThatOfTheMixedSchemeOnTheSameBonds) {
  const Cloud<2> cloud = cube<2>(6);
  MixedOptions choice;
  choice.gradient = "compatible";
  Mixed<2> mixed = mixed_body(cloud, choice, {}, LawChoice("neo-hookean"), rubber);
  const InitialMotion<2> motion = rough_motion(cloud, 0.2, 3);
  const MixedState<2> moving = mixed.start(motion);
  MixedState<2> rate = moving;
  ASSERT_FALSE(mixed.rates(moving, 0, rate));
  Solid<2> solid;
  solid.cloud = cloud;
  solid.elastic = rubber;
  solid.bonds = mixed.bonds().table;
  solid.sweeps = sweeps_named<2>("neo-hookean", rubber, solid.bonds);
  solid.volume.assign(solid.bonds.slots.count(), 0.0);
  for (Index i = 0; i < cloud.size(); ++i) solid.volume[solid.bonds.slots.of(i)] = mixed.cloud().V[i];
  add_term(solid, pair_upwind_term(solid));
  State<2> state = make_state(solid);
  for (Index i = 0; i < cloud.size(); ++i) {
    set_vector<2>(state.u, solid.bonds.slots.of(i), motion.u[i]);
    set_vector<2>(state.v, solid.bonds.slots.of(i), motion.v[i]);
  }
  const std::vector<Vec<2>> f = forces(solid, state);
  double most = 0;
  for (const Vec<2>& force : f) most = std::max(most, force.norm());
  for (Index i = 0; i < cloud.size(); ++i)
    EXPECT_LT((f[i] - rubber.density * vector_at<2>(rate.v, solid.bonds.slots.of(i))).norm(),
              rounding * most);
}

/// Accelerations per velocity at rest [1/s].
Eigen::MatrixXd upwind_matrix(const Solid<2>& solid) {
  const Index n = 2 * solid.cloud.size();
  Eigen::MatrixXd A(n, n);
  for (Index column = 0; column < n; ++column) {
    State<2> state = make_state(solid);
    state.v[static_cast<int>(column % 2)][solid.bonds.slots.of(column / 2)] = 1;
    const auto f = upwind_force(solid, state);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      A.block<2, 1>(2 * i, column) = f[i] / solid.elastic.density;
  }
  return A;
}

TEST(PairUpwind, StepLimitIsTheStabilityRegionOverTheLargestEigenvalue) {
  for (const double jitter : {0.0, 0.15}) {
    const Solid<2> solid = upwind_block<2>("improved", jitter);
    const Eigen::VectorXd rates = upwind_matrix(solid).eigenvalues().real();
    EXPECT_NEAR(pair_upwind_step_limit(solid, 2.0) * -rates.minCoeff(), 2,
                0.1);                                       // 30 steps of power iteration
    EXPECT_LT(rates.maxCoeff(), 1e-9 * -rates.minCoeff());  // nothing grows
  }
}

// On a chain the symbol is (2c/d) sin^6(theta/2): the alternating mode has the rate 2c/d, fourth order is what is left of smooth ones.
TEST(PairUpwind, SymbolOnAChain) {
  Cloud<1> chain = cube<1>(64);
  const auto how = options<1>(Scheme(), chain.spacing);
  const Solid<1> solid = make_solid<1>(std::move(chain), "neo-hookean", rubber, how);
  const double d = solid.cloud.spacing, c = followed_pressure_speed(solid.elastic);
  for (const double theta : {std::acos(-1.0), 2.0, 1.0, 0.5}) {
    State<1> state = make_state(solid);
    for (Index i = 0; i <= 64; ++i)
      state.v[0][solid.bonds.slots.of(i)] = std::cos(theta * static_cast<double>(i - 32));
    const double rate = -upwind_force(solid, state)[32][0] / solid.elastic.density;
    EXPECT_NEAR(rate, 2 * c / d * std::pow(std::sin(theta / 2), 6), 1e-9 * c / d);
  }
}

TEST(PairUpwind, EnergyRisesInNoStep) {
  Solid<2> solid = upwind_block<2>("compatible", 0);
  add_term(solid, pair_upwind_term(solid));
  State<2> state = rough_state(solid);
  for (int k = 0; k < 2; ++k)
    for (Index i = 0; i < solid.bonds.slots.count(); ++i) state.u[k][i] *= 0.3;
  const ChosenIntegrator<2> integrator = integrator_named<2>("rk3", solid);
  StepControl control;
  control.fixed_step = 0.5 * solid.cloud.spacing / solid.elastic.wave_speed();
  control.max_steps = 80;
  const double start = energy_of(solid, state).total();
  double before = start, most = -1;
  const auto result = run<2>(solid, state, integrator, control, [&](const Solid<2>& now, const State<2>& s) {
    const double energy = energy_of(now, s).total();
    most = s.step == 0 ? -1 : std::max(most, energy - before);
    before = energy;
    return true;
  });
  EXPECT_TRUE(result.completed());
  EXPECT_LE(most, 0);
  EXPECT_LT(before, 0.9 * start);  // alternating motion is gone
}

// The budget books all that it does as its own.
TEST(PairUpwind, ItsWorkIsItsOwnInTheBudget) {
  Solid<2> solid = upwind_block<2>("compatible", 0);
  add_term(solid, pair_upwind_term(solid));
  State<2> state = rough_state(solid);
  const ChosenIntegrator<2> integrator = integrator_named<2>("rk3", solid);
  const double start = energy_of(solid, state).total();
  Budget<2> budget(solid, state, integrator.weights);
  StepControl control;
  control.fixed_step = 0.02 * solid.cloud.spacing / solid.elastic.wave_speed();
  control.max_steps = 20;
  run<2>(solid, state, integrator, control, [&](const Solid<2>& now, const State<2>& s) {
    if (s.step > 0) budget.close_step(now, s);
    return true;
  });
  const double lost = energy_of(solid, state).total() - start;
  EXPECT_LT(lost, 0);
  EXPECT_NEAR(budget.total().part("dissipation").energy, lost, 1e-3 * std::abs(lost));  // of such steps
  EXPECT_LT(budget.total().angular_gap, rounding);
}

TEST(PairUpwind, SameBitsForAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  std::vector<std::vector<Vec<2>>> found;
  for (const int n : {1, 2, 3}) {
    omp_set_num_threads(n);
    Solid<2> solid = rubber_block<2>(70, Layout::node, 0.1);  // 20 blocks
    add_term(solid, pair_upwind_term(solid));
    State<2> state = rough_state(solid);
    found.push_back(forces(solid, state));
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

}  // namespace
}  // namespace plumb::testing
