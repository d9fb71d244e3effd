// What the dissipation between pairs may and may not do, for each of its jumps.
#include <gtest/gtest.h>

#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

/// Acceleration and heating of every particle, with the scales that rounding is measured by.
template <int d>
struct Rates {
  std::vector<Vec<d>> a;
  std::vector<double> heat;
};

template <int d>
Rates<d> rates_of(Mixed<d>& body, const MixedState<d>& state) {
  MixedState<d> rate = state;
  EXPECT_FALSE(body.rates(state, 0, rate));
  Rates<d> found;
  for (Index p = 0; p < body.cloud().size(); ++p) {
    const Index i = body.bonds().table.slots.of(p);
    found.a.push_back(vector_at<d>(rate.v, i));
    found.heat.push_back(rate.heat.components() ? rate.heat[0][i] : 0);
  }
  return found;
}

template <int d>
struct Sums {
  Vec<d> force = Vec<d>::Zero();
  double torque = 0, power = 0, heat = 0;  // of the pairs [N m], [W]
  double force_scale = 0, torque_scale = 0, power_scale = 0;
  double least_heat = 0, most_heat = 0;
};

/// Sums over a free body in a rough motion, upwinding less none where it says power.
template <int d>
Sums<d> sums(const std::string& upwind, const std::string& volumes, bool jitter) {
  Cloud<d> cloud = cube<d>(4);
  if (jitter) cloud = jittered<d>(std::move(cloud), 0.15, 5, Layout::node);
  MixedOptions with = mixed_options(upwind), without = mixed_options("none");
  with.volumes = without.volumes = volumes;
  const InitialMotion<d> motion = rough_motion(cloud, 0.2, 3);
  Mixed<d> body = mixed_body(cloud, with), plain = mixed_body(cloud, without);
  const MixedState<d> state = body.start(motion);
  const Rates<d> rates = rates_of(body, state), elastic = rates_of(plain, plain.start(motion));
  const Snapshot<d> shown = body.snapshot(state);
  Sums<d> s;
  for (std::size_t i = 0; i < rates.a.size(); ++i) {
    const Vec<d> f = shown.mass[i] * rates.a[i], pair = f - shown.mass[i] * elastic.a[i];
    s.force += f;
    s.force_scale += f.norm();
    s.torque += shown.x[i][0] * f[1] - shown.x[i][1] * f[0];
    s.torque_scale += shown.x[i].norm() * f.norm();
    s.power += pair.dot(shown.v[i]);
    s.power_scale += std::abs(pair.dot(shown.v[i]));
    s.heat += body.cloud().V[i] * rates.heat[i];
    s.least_heat = std::min(s.least_heat, rates.heat[i]);
    s.most_heat = std::max(s.most_heat, rates.heat[i]);
  }
  return s;
}

constexpr double round_off = 1e-12;  // of sums over some hundred particles and 26 neighbours

template <int d>
void keeps_the_laws(const std::string& upwind, const std::string& volumes, bool jitter) {
  SCOPED_TRACE(std::to_string(d) + "D " + upwind + " " + volumes + (jitter ? " jittered" : ""));
  const Sums<d> s = sums<d>(upwind, volumes, jitter);
  EXPECT_LT(s.force.norm(), round_off * s.force_scale);
  EXPECT_NEAR(s.power, -s.heat, round_off * s.power_scale);  // what the pairs take is what is booked
  if (upwind == "adjoint") {
    EXPECT_LT(std::abs(s.torque), round_off * s.torque_scale);
    EXPECT_GE(s.least_heat, 0);
  }
  if (upwind == "constant") {
    EXPECT_GE(s.least_heat, 0);
  }
  EXPECT_GT(s.heat, 0);
}

TEST(Upwinding, KeepsMomentumAndBooksItsHeat) {
  for (const char* upwind : {"constant", "reconstructed", "adjoint"})
    for (const char* volumes : {"equal", "tributary"})
      for (const bool jitter : {false, true}) {
        keeps_the_laws<2>(upwind, volumes, jitter);
        keeps_the_laws<3>(upwind, volumes, jitter);
      }
}

// So that the law above can fail: only the adjoint form is free of torque and never feeds energy.
TEST(Upwinding, TheOtherJumpsTurnTheBody) {
  for (const char* upwind : {"constant", "reconstructed"}) {
    const Sums<2> s = sums<2>(upwind, "equal", false);
    EXPECT_GT(std::abs(s.torque), 1e-5 * s.torque_scale) << upwind;
  }
}

/// Mean square of the heating by a field of velocities in a deformed state, and what a rough one gives.
template <int d>
double heat_of(const std::string& upwind, const InitialMotion<d>& motion, const Cloud<d>& cloud) {
  Mixed<d> body = mixed_body(cloud, mixed_options(upwind));
  double most = 0;
  for (const double heat : rates_of(body, body.start(motion)).heat) most = std::max(most, std::abs(heat));
  return most;
}

template <int d>
void spares_rigid_rotations() {
  const Cloud<d> cloud = cube<d>(4);
  InitialMotion<d> motion = rough_motion(cloud, 0.2, 3);
  const double rough = heat_of("adjoint", motion, cloud);
  std::vector<Vec<d>> x = cloud.X;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += motion.u[i];
  motion.v = spinning(x, 10);
  EXPECT_LT(heat_of("adjoint", motion, cloud), 1e-20 * rough);  // the square of a jump at round-off
  EXPECT_GT(heat_of("reconstructed", motion, cloud), 1e-6 * rough);
  EXPECT_GT(heat_of("constant", motion, cloud), 1e-3 * rough);
}

TEST(Upwinding, TheAdjointJumpOfARigidRotationIsZeroInAnyState) {
  spares_rigid_rotations<2>();
  spares_rigid_rotations<3>();
}

TEST(Upwinding, AReconstructedJumpIsZeroForFieldsLinearInTheReference) {
  const Cloud<2> cloud = cube<2>(5);
  InitialMotion<2> motion = rough_motion(cloud, 0.2, 3);
  const double rough = heat_of("reconstructed", motion, cloud);
  Mat<2> G;
  G << 1, 2, -3, 0.5;
  for (std::size_t i = 0; i < cloud.X.size(); ++i) motion.v[i] = G * cloud.X[i];
  EXPECT_LT(heat_of("reconstructed", motion, cloud), 1e-14 * rough);  // a jump at round-off times dv
  EXPECT_GT(heat_of("adjoint", motion, cloud), 1e-6 * rough);         // it is linear in x only if u is
}

// A chain at rest but for one particle: two pairs with rho c/(2d) each and a jump of 1 m/s.
TEST(Upwinding, ValueOnAChain) {
  Cloud<1> chain = cube<1>(8);
  Mixed<1> body = mixed_body(chain, mixed_options("constant"));
  InitialMotion<1> motion{{}, std::vector<Vec<1>>(9, Vec<1>::Zero())};
  motion.v[4][0] = 1;
  const double c = column_rubber.wave_speed(), d = chain.spacing;
  const Rates<1> rates = rates_of(body, body.start(motion));
  EXPECT_NEAR(rates.a[4][0], -c / d, 1e-9 * c / d);
  EXPECT_NEAR(rates.a[3][0], c / (2 * d), 1e-9 * c / d);
  EXPECT_NEAR(rates.heat[4], column_rubber.density * c / (2 * d), 1e-6);
  EXPECT_NEAR(rates.heat[3], column_rubber.density * c / (4 * d), 1e-6);
}

// Along the pair c_p counts, across it c_s: a 2D row moved along or across. The speed is over the mean least
// stretch of the pair.
TEST(Upwinding, SpeedsAlongAndAcrossAPair) {
  const Cloud<2> cloud = cube<2>(6);
  const auto loss = [&](const Vec<2>& v, double stretch) {
    Mixed<2> body = mixed_body(cloud, mixed_options("constant"));
    InitialMotion<2> motion;
    for (const Vec<2>& X : cloud.X) {
      motion.u.push_back((stretch - 1) * X);
      motion.v.push_back(std::abs(X[0]) < 1e-9 ? v : Vec<2>::Zero());
    }
    double sum = 0;
    for (const double heat : rates_of(body, body.start(motion)).heat) sum += heat;
    return sum;
  };
  // a column of particles against its neighbours: shares of the pairs with n along x and at 45 degrees
  const double along = loss({1, 0}, 1), across = loss({0, 1}, 1);
  const double cp = column_rubber.wave_speed(), cs = column_rubber.shear_wave_speed();
  EXPECT_GT(along, across);
  EXPECT_LT(along / across, cp / cs);
  // along = A cp + B (cp + cs)/2, across = A cs + B (cp + cs)/2
  EXPECT_NEAR(loss({1, 1}, 1), along + across, 1e-9 * along);  // across is what n (x) n leaves; no mixed term
  EXPECT_NEAR(loss({1, 0}, 0.8), along / 0.8, 1e-9 * along);
  EXPECT_NEAR(loss({1, 0}, 1.25), along, 1e-9 * along);  // the 3 x 3 tensor keeps 1 out of the plane
}

}  // namespace
}  // namespace plumb::testing
