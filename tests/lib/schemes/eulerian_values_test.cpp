// Numbers that lattices, rotations and small forces fix: what the sums of paper 001 give, by another program.
#include <gtest/gtest.h>

#include "lib/schemes/point_fields.hpp"
#include "tests/support/eulerian.hpp"

namespace plumb::testing {
namespace {

/// Shepard sum and moments of the particle nearest to a point of a lattice with cells of 1 m.
template <int d>
std::pair<double, Mat<d>> sums_at(const Vec<d>& point) {
  std::array<Index, d> count;
  count.fill(9);
  const Cloud<d> cloud = cells<d>(count, 1.0);
  const auto body = eulerian_body<d>(cloud, plain("printed"));
  const Index i = nearest<d>(cloud, point);
  return {body.shepard()[i], body.moments()[i]};
}

TEST(EulerianLattice, SumsOfTheKernel) {
  const auto [S, M] = sums_at<2>({0, 0});
  EXPECT_NEAR(S, 0.999946768955873, 2e-15);  // the digits that are given
  EXPECT_NEAR(M(0, 0), 1.01054295725339, 2e-14);
  const auto [S1, M1] = sums_at<2>({0, -4});  // first row
  EXPECT_NEAR(S1, 0.763226048758883, 2e-15);
  EXPECT_NEAR(M1(0, 0), 0.773484241955505, 2e-15);
  EXPECT_NEAR(M1(1, 1), 0.505271478626697, 2e-15);
  EXPECT_NEAR((sums_at<2>({0, -3}).first), 0.990381644828691, 2e-15);
  const auto [S2, M2] = sums_at<2>({-4, -4});  // corner
  EXPECT_NEAR(S2, 0.580506872619617, 2e-15);
  EXPECT_NEAR(M2(0, 0), 0.386742120977752, 2e-15);
  EXPECT_NEAR(M2(0, 1), 0.113088690855135, 2e-15);
  const auto [S3, M3] = sums_at<3>({0, 0, 0});
  EXPECT_NEAR(S3, 0.997261828303877, 3e-15);
  EXPECT_NEAR(M3(0, 0), 0.993483699944107, 3e-15);
  EXPECT_NEAR((sums_at<3>({0, 0, -4}).first), 0.767847351948, 1e-12);
  EXPECT_NEAR((sums_at<3>({0, -4, -4}).first), 0.589407612178, 1e-12);
  EXPECT_NEAR((sums_at<3>({-4, -4, -4}).first), 0.450994117948, 1e-12);
}

RateLaw<3> stiff() {
  return {LawChoice("linear-elastic"), {2.5, 0.25, 1}, true, true, std::nullopt, "eulerian"};  // mu = 1
}

/// S_xx and S_xy over mu of simple shear to that gamma in so many steps, by increments of the middle of a step.
std::pair<double, double> sheared(double gamma, int steps) {
  RateLaw<3>::Point point{Mat<3>::Zero()};
  Mat<3> increment = Mat<3>::Zero();
  increment(0, 1) = gamma / steps;
  for (int n = 0; n < steps; ++n) stiff().advance_by(point, increment, 1, 1);
  return {point.s(0, 0), point.s(0, 1)};
}

TEST(EulerianLaw, SimpleShearIsOfOrderTwo) {
  // the exact solution of Jaumann's rate: S_xx = mu (1 - cos gamma), S_xy = mu sin gamma
  EXPECT_NEAR(sheared(4, 400).second, -0.75679232, 5e-9);  // the digits that are given
  EXPECT_NEAR(std::sin(4.0), -0.75680250, 5e-9);
  for (const int steps : {50, 100, 200}) {
    const auto coarse = sheared(4, steps), fine = sheared(4, 2 * steps);
    // the next term is of order four: a few per mille at these steps
    EXPECT_NEAR((coarse.second - std::sin(4.0)) / (fine.second - std::sin(4.0)), 4, 0.02) << steps;
    EXPECT_NEAR((coarse.first - 1 + std::cos(4.0)) / (fine.first - 1 + std::cos(4.0)), 4, 0.02) << steps;
  }
}

TEST(EulerianLaw, ATurnChangesNothing) {
  // one turn about z in 100 steps: x_end - x_start = (I - R^T) x_end, with respect to the middle (I - R^T)(I + R^T)^-1 2
  const double angle = 2 * std::acos(-1.0) / 100;
  Mat<3> R = Mat<3>::Identity();
  R.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Mat<3> I = Mat<3>::Identity(), L = I - R.transpose(), increment = L * (I - 0.5 * L).inverse();
  Mat<3> s = Mat<3>::Zero();
  s.diagonal() << 1, -2, 1;
  s(0, 1) = s(1, 0) = 0.5;
  RateLaw<3>::Point point{s};
  for (int n = 0; n < 100; ++n) stiff().advance_by(point, increment, 1, 1);
  EXPECT_NEAR((point.s - s).norm(), 0, 1e-13);  // a hundred products of two rotations
  EXPECT_NEAR(increment.trace(), 0, 1e-15);     // so the density is kept
}

/// One particle of 4 x 4 is moved by a tenth of the spacing and F is I everywhere: what acts on it then, with
/// K = 1, mu = 1/2 and density 1.
struct Displaced {
  Vec<2> force;
  double power;
};
/// Shear stresses, whose principal stresses are of the same size, of the displaced particle and of the others.
struct Shear {
  double own = 0, others = 0;
};
Displaced displaced(EulerianOptions o, const Vec<2>& velocity, double density = 1, const Shear& shear = {}) {
  o.damping = "none";
  const Cloud<2> cloud = cells<2>({4, 4}, 1.0);
  const Index k = nearest<2>(cloud, Vec<2>(-0.4, -0.4));
  auto body = eulerian_body<2>(cloud, o, {9.0 / 7, 2.0 / 7, density});
  auto state = body.start({});
  state.u[0][k] = state.place[0][k] = 0.1;  // the reference of (30) lies there, so that F is that of before
  set_vector<2>(state.v, k, velocity);
  for (Index i = 0; i < cloud.size(); ++i)
    state.stress[1][i] = state.stress[2][i] = i == k ? shear.own : shear.others;
  EXPECT_FALSE(body.advance(state, 1e-13));  // what moves meanwhile is of this size
  const Vec<2> force = vector_at<2>(state.hourglass, k);
  return {force, force.dot(velocity)};
}

TEST(EulerianHourglass, SpringsPullBack) {
  EulerianOptions o;
  o.xi = 1;
  EXPECT_NEAR(displaced(o, {0, 0}).force[0], -0.0387224405, 1e-10);
  o.misprints = {"32"};
  EXPECT_NEAR(displaced(o, {0, 0}).force[0], 0.0387224405, 1e-10);
}

TEST(EulerianHourglass, TheIncrementalErrorIsForgottenAtEachReference) {
  EulerianOptions o;
  o.xi = 1;
  o.incremental_error = true;  // the latest reference holds the displaced particle: there is no error since
  EXPECT_LT(displaced(o, {0, 0}).force.norm(), 1e-15);  // rounding
  const Cloud<2> cloud = cells<2>({6, 6}, 0.5);
  const auto pull = [&](bool incremental) {  // a zigzag, before there is any other reference
    o.incremental_error = incremental;
    auto body = eulerian_body<2>(cloud, o);
    auto state = body.start({});
    for (Index i = 0; i < cloud.size(); ++i) state.u[0][i] = i % 2 ? 0.01 : -0.01;
    EXPECT_FALSE(body.advance(state, 1e-13));
    return Vec<2>(vector_at<2>(state.hourglass, 14));
  };
  EXPECT_EQ(pull(true), pull(false));
  EXPECT_GT(pull(true).norm(), 1e-3);
}

/// xi + xi_t (s/E)^2, and the mean of both particles of a pair.
TEST(EulerianHourglass, TensionStiffensSprings) {
  EulerianOptions o;
  o.xi = 1;
  o.xi_tension = 5;
  const double E = 9.0 / 7, s = 0.3, more = 5 * s * s / (E * E), plain = -0.0387224405;
  EXPECT_NEAR(displaced(o, {0, 0}).force[0], plain, 1e-10);
  EXPECT_NEAR(displaced(o, {0, 0}, 1, {s, s}).force[0], plain * (1 + more), 1e-10);
  EXPECT_NEAR(displaced(o, {0, 0}, 1, {s, 0}).force[0], plain * (1 + more / 2), 1e-10);
  EXPECT_NEAR(displaced(o, {0, 0}, 1, {0, s}).force[0], plain * (1 + more / 2), 1e-10);
  o.hourglass = "mixed";
  o.zeta = 0;
  o.chi = 0.2;
  EXPECT_NEAR(displaced(o, {0, 0}, 1, {s, s}).force[0], 0.8 * plain * (1 + more), 1e-10);
}

/// The step follows the stiffest spring: its factor over 4, from 4 on. A density above that of rest is pressure, which
/// takes tension away.
TEST(EulerianHourglass, TensionShortensTheStep) {
  EulerianOptions o;
  o.xi = 1;
  o.xi_tension = 100;
  const Cloud<2> cloud = cells<2>({4, 4}, 1.0);
  auto body = eulerian_body<2>(cloud, o, {9.0 / 7, 2.0 / 7, 1});
  auto state = body.start({});
  const double at_rest = body.step_limit(state), E = 9.0 / 7;
  state.stress[1][5] = state.stress[2][5] = 0.5;
  EXPECT_NEAR(at_rest / body.step_limit(state), std::sqrt((1 + 100 * 0.25 / (E * E)) / 4), 1e-12);
  state.density[0][5] = 2;
  EXPECT_EQ(body.step_limit(state), at_rest);
}

TEST(EulerianHourglass, DampersTakeEnergy) {
  EulerianOptions o;
  o.hourglass = "viscous";
  o.zeta = 1;
  EXPECT_NEAR(displaced(o, {0.3, 0.1}).power, -0.00705975, 1e-8);
  // by density and speed of sound: twice as much at four times the density
  EXPECT_NEAR(displaced(o, {0.3, 0.1}, 4).power, 2 * -0.00705975, 2e-8);
  // where the error falls, nothing acts
  EXPECT_EQ(displaced(o, {-0.3, 0}).power, 0);
  o.misprints = {"33"};
  EXPECT_NEAR(displaced(o, {0.3, 0.1}).power, 0.00705975, 1e-8);
}

TEST(EulerianHourglass, TheMixedControlIsTheWeightedSum) {
  EulerianOptions spring, damper, mixed;
  spring.xi = mixed.xi = 0.7;
  damper.hourglass = "viscous";
  damper.zeta = mixed.zeta = 3;
  mixed.hourglass = "mixed";
  mixed.chi = 0.2;
  const Vec<2> v(0.3, 0.1);
  const Vec<2> sum = 0.8 * displaced(spring, v).force + 0.2 * displaced(damper, v).force;
  EXPECT_NEAR((displaced(mixed, v).force - sum).norm(), 0, 1e-16);
}

/// The mode of the free square whose edges have no traction, and what a field has of it.
Vec<2> lame(const Vec<2>& X) {
  const double k = std::acos(-1.0);
  return {std::cos(k * X[0]) * std::sin(k * X[1]), -std::sin(k * X[0]) * std::cos(k * X[1])};
}

/// Modal amplitudes over U after 1 and 20 steps of 10 x 10 particles.
std::pair<double, double> amplitudes(const EulerianOptions& o) {
  const double U = 1e-5, omega = std::acos(-1.0) * std::sqrt(2 * 0.715e6 / 1000);
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, {10, 10}, Layout::cell);
  auto body = eulerian_body<2>(cloud, o);
  auto state = body.start(moving<2>(cloud, [&](const Vec<2>& X) { return Vec<2>(U * omega * lame(X)); }));
  const auto amplitude = [&] {
    double sum = 0, square = 0;
    for (Index i = 0; i < cloud.size(); ++i) {
      sum += vector_at<2>(state.u, i).dot(lame(cloud.X[i]));
      square += lame(cloud.X[i]).squaredNorm();
    }
    return sum / square / U;
  };
  EXPECT_FALSE(body.advance(state, 7.777733608e-4));
  const double first = amplitude();
  for (int n = 1; n < 20; ++n) EXPECT_FALSE(body.advance(state, 7.777733608e-4));
  return {first, amplitude()};
}

TEST(EulerianLameMode, HasTheAmplitudesOfAnotherProgram) {
  EulerianOptions o;
  o.damping = "none";
  const auto adjoint = amplitudes(o), printed = amplitudes(EulerianOptions::of_paper());
  EXPECT_NEAR(adjoint.first, 0.09239978393, 5e-11);
  EXPECT_NEAR(adjoint.second, 0.9945699358843, 2e-10);  // programs may differ by strains of 3e-5 squared
  EXPECT_NEAR(printed.first, 0.09239978393, 5e-11);
  EXPECT_NEAR(printed.second, 1.012772140, 5e-10);
}

/// Error in L2 over the norm of the mode, at a quarter of the period, of n x n particles.
double error_of(const EulerianOptions& o, Index n) {
  const double U = 1e-5, omega = std::acos(-1.0) * std::sqrt(2 * 0.715e6 / 1000),
               end = std::acos(-1.0) / (2 * omega);
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, {n, n}, Layout::cell);
  auto body = eulerian_body<2>(cloud, o);
  auto state = body.start(moving<2>(cloud, [&](const Vec<2>& X) { return Vec<2>(U * omega * lame(X)); }));
  const auto steps = std::lround(std::ceil(end / body.step_limit(state)));
  for (long step = 0; step < steps; ++step)
    EXPECT_FALSE(body.advance(state, end / static_cast<double>(steps)));
  double square = 0, norm = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    square += (vector_at<2>(state.u, i) / U - lame(cloud.X[i])).squaredNorm();
    norm += lame(cloud.X[i]).squaredNorm();
  }
  return std::sqrt(square / norm);
}

TEST(EulerianLameMode, HasTheErrorsOfAnotherProgram) {
  EulerianOptions adjoint = plain("adjoint"), printed = plain("printed"), uncorrected = plain("plain");
  adjoint.cfl = printed.cfl = uncorrected.cfl = 0.4;
  const double of_adjoint[] = {8.3078e-2, 2.4961e-2, 6.8023e-3, 1.7713e-3},
               of_printed[] = {7.1717e-2, 2.0486e-2, 5.6214e-3, 4.6618e-3},
               of_uncorrected[] = {5.5945e-2, 1.4727e-2, 3.9382e-3};
  for (int level = 0; level < 4; ++level) {
    const Index n = 10 << level;
    EXPECT_NEAR(error_of(adjoint, n) / of_adjoint[level], 1, 1e-4) << n;  // five digits are given
    EXPECT_NEAR(error_of(printed, n) / of_printed[level], 1, 1e-4) << n;  // it stalls
  }
  for (int level = 0; level < 3; ++level)
    EXPECT_NEAR(error_of(uncorrected, 10 << level) / of_uncorrected[level], 1, 1e-4) << level;
}

}  // namespace
}  // namespace plumb::testing
