// Values: the time step of a body whose stretch differs from particle to particle, steps of every integrator
// against the formulas of chapter 7 written out, and the bounds at which a run ends, from both sides.
#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/parts/jst.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "lib/schemes/tlsph/time/closest_pairs.hpp"
#include "lib/schemes/tlsph/time/time_step.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

template <int d>
using Vectors = std::vector<Vec<d>>;

/// The crossing time by (7.3), read particle by particle: C of a pair is C_p, or C_p times or over the mean
/// of the two least stretches.
template <int d>
double plain_crossing(const Solid<d>& solid, const State<d>& state, WaveSpeed speed) {
  const double C = std::sqrt((solid.elastic.bulk_modulus() + 4.0 / 3 * solid.elastic.shear_modulus()) /
                             solid.elastic.density);
  const double R = 2 * solid.smoothing_length * (1 - 1e-12);  // of the cubic spline
  std::vector<double> stretch;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    stretch.push_back(
        Eigen::JacobiSVD<Mat<d>>(deformation_gradient_of(solid, state, i)).singularValues().minCoeff());
  double least = 1e300;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (Index j = 0; j < solid.cloud.size(); ++j) {
      if (i == j || (solid.cloud.X[j] - solid.cloud.X[i]).norm() >= R) continue;
      const double r = (position_of(solid, state, j) - position_of(solid, state, i)).norm(),
                   mean = (stretch[i] + stretch[j]) / 2;
      least = std::min(least, r / (speed == WaveSpeed::linear    ? C
                                   : speed == WaveSpeed::stretch ? C * mean
                                                                 : C / mean));
    }
  return least;
}

template <int d>
void expect_crossing(double jitter) {
  const Solid<d> solid = rubber_block<d>(d == 2 ? 9 : 6, Layout::node, jitter);
  State<d> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i) {  // stretches from 0.4 to 1.6 along the body
    Vec<d> u = Vec<d>::Zero();
    const Vec<d>& X = solid.cloud.X[i];
    u[0] = -0.6 * X[0] + 0.6 * X[0] * X[0];
    u[1] = 0.2 * X[0] * X[1];
    set_vector<d>(state.u, solid.bonds.slots.of(i), u);
  }
  for (const WaveSpeed speed : {WaveSpeed::linear, WaveSpeed::stretch, WaveSpeed::stretch_inverse}) {
    const double expected = plain_crossing(solid, state, speed);
    EXPECT_NEAR(crossing_time(solid, state, speed), expected, 1e-12 * expected)
        << d << "D " << name_of(speed) << ' ' << jitter;
  }
  // the three are not the same number here
  EXPECT_GT(std::abs(plain_crossing(solid, state, WaveSpeed::stretch) /
                         plain_crossing(solid, state, WaveSpeed::linear) -
                     1),
            0.05);
}

TEST(CrossingTimeValues, TakeTheMeanStretchOfEachPair) {
  for (const double jitter : {0.0, 0.2}) {
    expect_crossing<2>(jitter);
    expect_crossing<3>(jitter);
  }
}

TEST(WaveSpeeds, AreNamedAsTheyAreRead) {
  for (const char* name : {"linear", "stretch", "stretch-inverse"})
    EXPECT_EQ(name_of(wave_speed_named(name)), name);
  EXPECT_EQ(wave_speed_named("stretch"), WaveSpeed::stretch);
  EXPECT_EQ(wave_speed_named("stretch-inverse"), WaveSpeed::stretch_inverse);
  EXPECT_THROW(wave_speed_named("stretched"), InputError);
}

TEST(TimeStep, IsTheLeastOfCflAndOtherLimitsUnlessItIsFixed) {
  Solid<2> solid = rubber_block<2>(6, Layout::cell, 0);
  const State<2> state = make_state(solid);
  StepControl control;
  control.cfl = 0.37;
  const double crossing = solid.cloud.spacing / solid.elastic.wave_speed();
  EXPECT_NEAR(time_step(solid, state, control), 0.37 * crossing, 1e-12 * crossing);
  ClosestPairs<2> closest;
  EXPECT_NEAR(next_time_step(solid, state, control, closest), 0.37 * crossing, 1e-12 * crossing);
  solid.step_limit = 0.2 * crossing;
  EXPECT_DOUBLE_EQ(time_step(solid, state, control), 0.2 * crossing);
  EXPECT_DOUBLE_EQ(next_time_step(solid, state, control, closest), 0.2 * crossing);
  control.fixed_step = 3 * crossing;
  EXPECT_DOUBLE_EQ(time_step(solid, state, control), 3 * crossing);
}

/// Acceleration of every particle at a state and time [m/s^2], with a load that varies in time.
template <int d>
struct Motion {
  Solid<d> solid;
  State<d> state;

  Motion()
      : solid(rubber_block<d>(5, Layout::node, 0.2,
                              {"improved", "adjoint", plumb::Correction::W1, 0.9, true})) {
    add_term(solid, jst_term(solid, {0.2, 0.05}));
    Term<d> load;
    load.name = "load";
    load.second = [](const Solid<d>&, const Block& block, const Instant<d>& now, BlockForce<d>& force) {
      for (Index i = block.begin(); i < block.end(); ++i)
        force(1, i) += 2e6 * (1 + 3e4 * now.time) * static_cast<double>(i % 3);
    };
    add_term(solid, load);
    state = make_state(solid);
    deform(solid, state, 0.05);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      for (int k = 0; k < d; ++k) state.v[k][i] = std::sin(3.0 * static_cast<double>(i) + k);
  }
  Vectors<d> read(const Field& field) const {
    Vectors<d> all;
    for (Index i = 0; i < solid.cloud.size(); ++i) all.push_back(vector_at<d>(field, i));
    return all;
  }
  Vectors<d> acceleration(const Vectors<d>& u, const Vectors<d>& v, double time) {
    State<d> at = make_state(solid);
    at.time = time;
    for (Index i = 0; i < solid.cloud.size(); ++i) set_vector<d>(at.u, i, u[i]), set_vector<d>(at.v, i, v[i]);
    auto a = forces(solid, at);
    for (auto& x : a) x /= solid.elastic.density;
    return a;
  }
};

template <int d>
Vectors<d> sum(double a, const Vectors<d>& x, double b, const Vectors<d>& y) {
  Vectors<d> s(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) s[i] = a * x[i] + b * y[i];
  return s;
}
template <int d>
void expect_equal(const Vectors<d>& found, const Vectors<d>& expected, double near) {
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_LT((found[i] - expected[i]).norm(), near) << i;
}

template <int d>
void expect_rk3() {
  Motion<d> motion;
  const double dt = 1e-5;
  auto u = motion.read(motion.state.u), v = motion.read(motion.state.v);
  auto integrator = integrator_named<d>("rk3", motion.solid);
  for (int n = 0; n < 2; ++n) {
    const double t = n * dt;
    const auto a0 = motion.acceleration(u, v, t);
    const auto u1 = sum<d>(1, u, dt, v), v1 = sum<d>(1, v, dt, a0);
    const auto a1 = motion.acceleration(u1, v1, t + dt);
    const auto u2 = sum<d>(0.75, u, 0.25, sum<d>(1, u1, dt, v1)),
               v2 = sum<d>(0.75, v, 0.25, sum<d>(1, v1, dt, a1));
    const auto a2 = motion.acceleration(u2, v2, t + dt / 2);
    u = sum<d>(1.0 / 3, u, 2.0 / 3, sum<d>(1, u2, dt, v2));
    v = sum<d>(1.0 / 3, v, 2.0 / 3, sum<d>(1, v2, dt, a2));
    ASSERT_TRUE(integrator.step(motion.solid, motion.state, dt));
    expect_equal<d>(motion.read(motion.state.u), u, 1e-15);  // displacements of some hundredths
    expect_equal<d>(motion.read(motion.state.v), v, 1e-13);  // velocities of some units
    EXPECT_DOUBLE_EQ(motion.state.time, (n + 1) * dt);
  }
}

template <int d>
void expect_verlet() {
  Motion<d> motion;
  const double dt = 1e-5;
  auto u = motion.read(motion.state.u), v = motion.read(motion.state.v);
  auto a = motion.acceleration(u, v, 0);
  auto integrator = integrator_named<d>("verlet", motion.solid);
  for (int n = 0; n < 3; ++n) {
    v = sum<d>(1, v, dt / 2, a);
    u = sum<d>(1, u, dt, v);
    a = motion.acceleration(u, v, (n + 1) * dt);
    v = sum<d>(1, v, dt / 2, a);
    ASSERT_TRUE(integrator.step(motion.solid, motion.state, dt));
    expect_equal<d>(motion.read(motion.state.u), u, 1e-15);
    expect_equal<d>(motion.read(motion.state.v), v, 1e-13);
    expect_equal<d>(motion.read(*integrator.carried()), a, 1e-7);  // of some 1e6
  }
}

TEST(Steps, AreTheFormulasWrittenOut) {
  expect_rk3<2>();
  expect_rk3<3>();
  expect_verlet<2>();
  expect_verlet<3>();
}

TEST(Integrators, SayWhatTheyAre) {
  const Solid<2> solid = rubber_block<2>(4, Layout::cell, 0);
  const auto rk3 = integrator_named<2>("rk3", solid), verlet = integrator_named<2>("verlet", solid);
  EXPECT_EQ(rk3.name, "rk3");
  EXPECT_EQ(verlet.name, "verlet");
  EXPECT_EQ(rk3.order, 3);
  EXPECT_EQ(verlet.order, 2);
  EXPECT_EQ(rk3.evaluations_per_step, 3);
  EXPECT_EQ(verlet.evaluations_per_step, 1);
  ASSERT_EQ(rk3.weights.size(), 3u);  // of a stage's acceleration in v(dt) - v(0), by (7.1)
  EXPECT_DOUBLE_EQ(rk3.weights[0], 2.0 / 3 / 4);
  EXPECT_DOUBLE_EQ(rk3.weights[1], 2.0 / 3 / 4);
  EXPECT_DOUBLE_EQ(rk3.weights[2], 2.0 / 3);
  ASSERT_EQ(verlet.weights.size(), 1u);
  EXPECT_DOUBLE_EQ(verlet.weights[0], 0.5);
  EXPECT_EQ(rk3.vectors_moved, 6);
  EXPECT_EQ(verlet.vectors_moved, 8);
  const std::size_t field = solid.make_field(2).bytes(), blocks = solid.blocks();
  EXPECT_EQ(rk3.bytes, 2 * field + blocks);
  EXPECT_EQ(verlet.bytes, 2 * field + blocks);
}

}  // namespace
}  // namespace plumb::testing
