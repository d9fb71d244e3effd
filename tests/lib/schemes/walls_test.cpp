// Particles against rigid walls, one by one: bounces, slides and rests that have closed forms.
#include "lib/schemes/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/geometry/closed_surface.hpp"

namespace plumb::testing {
namespace {

const double half_turn = std::acos(-1.0);  // pi

/// A particle of radius R beside a floor y = 0 (x = 0 in 1D), as a walls' own body: kick, drift, kick.
template <int d>
struct Ball {
  double radius = 0.01, mass = 0.05;
  RigidWall<d> wall;
  Vec<d> x = Vec<d>::Zero(), v = Vec<d>::Zero(), pull = Vec<d>::Zero();  // pull: acceleration of a load
  double time = 0, work = 0;
  Contact<d> contact = {};
  Field anchors = {}, u = Field(d, 1, 0);
  static constexpr int up = d == 1 ? 0 : 1;

  Ball(double modulus, double friction) {
    wall.beside = half_space<d>(Vec<d>::Zero(), Vec<d>::Unit(up));
    wall.modulus = modulus;
    wall.friction = friction;
    wall.reach = radius;
  }
  void start() {
    contact = Contact<d>({wall}, {x}, {mass}, radius);
    anchors = Field(contact.anchor_components(), 1, 0);
    contact.start(u, anchors);
  }
  Vec<d> pushed() {
    Field rate(d, 1, 0);
    contact.add(time, {x}, anchors, rate);
    return vector_at<d>(rate, 0);
  }
  void step(double dt) {
    const Vec<d> from = v, first = pushed();
    v += 0.5 * dt * (first + pull);
    x += dt * v;
    time += dt;
    const Vec<d> second = pushed();
    v += 0.5 * dt * (second + pull);
    work += mass * 0.5 * dt * (first + second).dot(0.5 * (from + v));
  }
  double kinetic() const { return 0.5 * mass * v.squaredNorm(); }
};

/// Hertz's impact: the depth (5 m v^2/(4 k))^(2/5), the time 2.943 depth/v and the same speed afterwards; in 2D and 1D half a
/// period of a spring. Returns the energy lost, over what there was.
template <int d>
double lost_in_a_bounce(int steps) {
  const double modulus = 1e6, speed = 0.5;
  Ball<d> ball(modulus, 0);
  ball.x[Ball<d>::up] = ball.radius;
  ball.v[Ball<d>::up] = -speed;
  ball.start();
  double depth = 0, time = 0;
  if constexpr (d == 3) {
    const double k = 4.0 / 3 * modulus * std::sqrt(ball.radius);
    depth = std::pow(5 * ball.mass * speed * speed / (4 * k), 0.4);
    time = 2.943275 * depth / speed;  // 2 int_0^1 dx/sqrt(1 - x^(5/2))
  } else {
    const double k = d == 2 ? half_turn / 4 * modulus : modulus / ball.radius;
    depth = speed * std::sqrt(ball.mass / k);
    time = half_turn * std::sqrt(ball.mass / k);
  }
  const double before = ball.kinetic();
  double deepest = 0, end = 0;
  for (int n = 0; n < 2 * steps && end == 0; ++n) {
    const double was = ball.x[Ball<d>::up] - ball.radius;
    ball.step(time / steps);
    const double is = ball.x[Ball<d>::up] - ball.radius;
    deepest = std::max(deepest, -is);
    if (is > 0) end = ball.time - time / steps * is / (is - was);
  }
  // the last overlap is passed at the speed of the start, so the line between two steps is good
  EXPECT_NEAR(end / time, 1, 1.0 / steps / steps) << d;
  EXPECT_NEAR(deepest / depth, 1, 2.0 / steps / steps) << d;
  EXPECT_NEAR((ball.work - (ball.kinetic() - before)) / before, 0, 1e-13) << d;
  return ball.kinetic() / before - 1;
}

TEST(Contact, ABounceTakesHertzsTimeAndKeepsTheEnergy) {
  for (const int steps : {40, 80}) {
    EXPECT_NEAR(lost_in_a_bounce<1>(steps), 0, 0.2 / steps / steps);
    EXPECT_NEAR(lost_in_a_bounce<2>(steps), 0, 0.2 / steps / steps);
    EXPECT_NEAR(lost_in_a_bounce<3>(steps), 0, 0.2 / steps / steps);
  }
}

TEST(Contact, TheSlopeIsThatOfTheForce) {
  const auto holds = [](auto press) {
    for (const double overlap : {1e-5, 1e-3, 5e-3}) {
      const double step = 1e-4 * overlap;
      const double slope = (press(overlap + step).force - press(overlap - step).force) / (2 * step);
      EXPECT_NEAR(press(overlap).slope / slope, 1, 1e-7);
    }
  };
  holds([](double o) { return press_of<1>(2e6, 0.01, o); });
  holds([](double o) { return press_of<2>(2e6, 0.01, o); });
  holds([](double o) { return press_of<3>(2e6, 0.01, o); });
  // the energy of (19.1) at a depth of 1 mm: 2/5 k d^(5/2)
  double energy = 0;
  for (int n = 0; n < 1000; ++n) energy += 1e-6 * press_of<3>(2e6, 0.01, 1e-6 * (n + 0.5)).force;
  EXPECT_NEAR(energy / (0.4 * 4.0 / 3 * 2e6 * 0.1 * std::pow(1e-3, 2.5)), 1, 1e-6);
}

/// A wall that comes with V throws a resting particle off with 2 V, and its work is that kinetic energy.
TEST(Contact, AWallThatMovesThrows) {
  Ball<3> ball(1e6, 0);
  ball.wall.displacement = [](double t) { return Vec<3>(0, 0.5 * t, 0); };
  ball.x[1] = ball.radius;
  ball.start();
  for (int n = 0; n < 800; ++n) ball.step(2e-5);
  EXPECT_NEAR(ball.v[1], 1, 1e-4);
  EXPECT_NEAR(ball.work, ball.kinetic(), 1e-14);
  EXPECT_EQ(ball.contact.force(0).norm(), 0);
}

/// A particle pressed to the floor by a load, which slides along x.
template <int d>
Ball<d> pressed(double friction) {
  Ball<d> ball(1e6, friction);
  const double g = 10, weight = ball.mass * g;
  ball.pull[1] = -g;
  const double overlap = d == 2 ? weight / (half_turn / 4 * 1e6)
                                : std::pow(weight / (4.0 / 3 * 1e6 * std::sqrt(ball.radius)), 2.0 / 3);
  ball.x[1] = ball.radius - overlap;
  return ball;
}

/// It is slowed down by mu g, stops after v^2/(2 mu g), and stays.
template <int d>
void slides() {
  Ball<d> ball = pressed<d>(0.3);
  ball.v[0] = 0.6;
  ball.start();
  const double dt = 1e-5, g = 10, stop = 0.6 / (0.3 * g);
  const double before = ball.kinetic();
  while (ball.time < 0.5 * stop) ball.step(dt);
  // the spring along the wall is stretched first: by mu F/k_t, some 1e-6 m, in the time that 0.6 m/s take for it
  EXPECT_NEAR(ball.v[0], 0.6 - 0.3 * g * ball.time, 5e-4) << d;
  EXPECT_NEAR(ball.contact.force(0)[0], -0.3 * ball.mass * g, 1e-9) << d;
  while (ball.time < 2 * stop) ball.step(dt);
  EXPECT_NEAR(ball.x[0], 0.6 * 0.6 / (2 * 0.3 * g), 5e-5) << d;
  EXPECT_LT(std::abs(ball.v[0]), 2e-2) << d;  // swings on its spring, which nothing damps
  EXPECT_NEAR(ball.work / before, -1, 1e-3) << d;
  EXPECT_NEAR(ball.contact.force(0)[1], ball.mass * g, 1e-9) << d;
}
TEST(Contact, ASlideIsSlowedDownByFriction) {
  slides<2>();
  slides<3>();
}

/// A pull below friction stretches the spring along the wall, which pulls back; above it the rest accelerates.
TEST(Contact, FrictionHoldsWhatItCan) {
  Ball<2> held = pressed<2>(0.3), slips = pressed<2>(0.3);
  held.pull[0] = 1;
  slips.pull[0] = 4;
  held.start();
  slips.start();
  for (int n = 0; n < 20000; ++n) {
    held.step(1e-5);
    slips.step(1e-5);
  }
  const double spring = Contact<2>::along * half_turn / 4 * 1e6;
  // a spring that is loaded at once swings to twice its rest
  EXPECT_LE(std::abs(held.x[0]), 2 * 1 * held.mass / spring * 1.001);
  EXPECT_GE(held.x[0], -1e-12);
  EXPECT_NEAR(slips.v[0], (4 - 3) * slips.time, 2e-3);
  // a particle that has left the floor begins anew where it lands
  held.x[1] = 2 * held.radius;
  held.x[0] = 5;
  held.pushed();
  EXPECT_EQ(held.anchors[0][0], 5);
}

/// A wall that slides carries what lies on it along.
TEST(Contact, FrictionIsThatOfTheRelativeMotion) {
  Ball<2> ball = pressed<2>(0.3);
  ball.wall.displacement = [](double t) { return Vec<2>(0.2 * t, 0); };
  ball.start();
  while (ball.time < 0.5 * 0.2 / 3) ball.step(1e-5);
  EXPECT_NEAR(ball.v[0], 3 * ball.time, 1e-4);
  while (ball.time < 1.5 * 0.2 / 3) ball.step(1e-5);
  double mean = 0;  // of what swings on its spring
  for (int n = 0; n < 20000; ++n) {
    ball.step(1e-5);
    mean += ball.v[0] / 20000;
  }
  EXPECT_NEAR(mean, 0.2, 2e-3);
}

/// Walls that touch a particle at once: forces of a corner, and the step for both springs.
TEST(Contact, WallsActTogether) {
  RigidWall<2> floor, side;
  floor.beside = half_space<2>(Vec<2>::Zero(), Vec<2>(0, 1));
  side.beside = half_space<2>(Vec<2>::Zero(), Vec<2>(1, 0));
  floor.modulus = 1e6;
  side.modulus = 3e6;
  floor.reach = side.reach = 0.01;
  side.friction = 0.1;
  floor.friction = 0.2;
  Contact<2> contact({floor, side}, {Vec<2>(0.008, 0.009)}, {0.5}, 0.01),
      alone({floor}, {Vec<2>(0, 0)}, {0.5}, 0.01);
  EXPECT_EQ(contact.anchor_components(), 4);
  Field anchors(4, 1, 0), rate(2, 1, 0), u(2, 1, 0);
  contact.start(u, anchors);
  contact.add(0, {Vec<2>(0.008, 0.009)}, anchors, rate);
  EXPECT_NEAR(rate[0][0], half_turn / 4 * 3e6 * 0.002 / 0.5, 1e-9);
  EXPECT_NEAR(rate[1][0], half_turn / 4 * 1e6 * 0.001 / 0.5, 1e-9);
  EXPECT_NEAR(contact.force(1)[0], half_turn / 4 * 3e6 * 0.002, 1e-9);
  // each has a spring of its own along it
  contact.add(0, {Vec<2>(0.0081, 0.0088)}, anchors, rate);
  EXPECT_NEAR(contact.force(0)[0], -Contact<2>::along * half_turn / 4 * 1e6 * 1e-4, 1e-9);
  EXPECT_NEAR(contact.force(1)[1], Contact<2>::along * half_turn / 4 * 3e6 * 2e-4, 1e-9);
  EXPECT_NEAR(alone.step_limit(), std::sqrt(0.5 / (half_turn / 4 * 1e6)), 1e-12);
  EXPECT_NEAR(contact.step_limit(), alone.step_limit() / 2, 1e-12);
}

/// A cube of triangles: beside a face it is a half-space, beside an edge the direction is that from the edge.
TEST(Contact, TrianglesPushAwayFromTheNearestPoint) {
  std::vector<double> corners;
  const auto quad = [&](const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& e) {
    for (const Vec<3>& p : {a, b, c, a, c, e}) corners.insert(corners.end(), p.begin(), p.end());
  };
  const Vec<3> p000(0, 0, 0), p100(1, 0, 0), p010(0, 1, 0), p110(1, 1, 0), p001(0, 0, 1), p101(1, 0, 1),
      p011(0, 1, 1), p111(1, 1, 1);
  quad(p000, p010, p110, p100);
  quad(p001, p101, p111, p011);
  quad(p000, p100, p101, p001);
  quad(p010, p011, p111, p110);
  quad(p000, p001, p011, p010);
  quad(p100, p110, p111, p101);
  TriangleMesh mesh = mesh_of_corners(corners);
  require_closed(mesh);
  const ClosedSurface cube(mesh);
  const auto expect = [&](const Vec<3>& x, double distance, const Vec<3>& away) {
    const BesideSurface<3> found = cube.beside(x);
    EXPECT_NEAR(found.distance, distance, 1e-15);
    EXPECT_NEAR((found.away - away).norm(), 0, 1e-14);
  };
  expect({0.3, 0.6, 1.25}, 0.25, {0, 0, 1});
  expect({0.3, 0.6, 0.875}, -0.125, {0, 0, 1});  // the surface is above it
  expect({0.3, 0.6, 1}, 0, {0, 0, 1});
  expect({1.3, 0.5, 1.4}, 0.5, {0.6, 0, 0.8});  // beside an edge
  expect({1.2, 1.2, 1.1}, 0.3, {2.0 / 3, 2.0 / 3, 1.0 / 3});
}

}  // namespace
}  // namespace plumb::testing
