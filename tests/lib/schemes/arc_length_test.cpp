// A shallow arch that snaps through: a path by arc length against the same arch under a prescribed
// displacement.
#include "lib/schemes/implicit/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/schemes/element/element.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "tests/support/mixed.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

constexpr double E = 1e6, span = 2, rise = 0.1, thickness = 0.04;

/// Half an arch y = rise sin^2(pi x/4), from its clamped foot at x = 0 to its middle, which cannot turn.
Cloud<2> half_arch() {
  Cloud<2> cloud = testing::nodes<2>({0, 0}, {span, thickness}, {40, 2});
  for (Vec<2>& X : cloud.X) X[1] += rise * std::pow(std::sin(std::numbers::pi * X[0] / (2 * span)), 2);
  cloud.line = 0;
  return cloud;
}

Held<2> holding_ends(const Cloud<2>& cloud) {
  Held<2> ends{"ends", {}, [](const Vec<2>&, int, double) { return HeldMotion{}; }};
  for (Index i = 0; i < cloud.size(); ++i) {
    for (int k = 0; k < 2 && cloud.X[i][0] < 1e-9; ++k) ends.places.push_back({i, k, cloud.X[i]});
    if (cloud.X[i][0] > span - 1e-9) ends.places.push_back({i, 0, cloud.X[i]});
  }
  return ends;
}

std::vector<Index> middle_nodes(const Cloud<2>& cloud) {
  std::vector<Index> nodes;
  for (Index i = 0; i < cloud.size(); ++i)
    if (cloud.X[i][0] > span - 1e-9) nodes.push_back(i);
  return nodes;
}

Element<2> arch(const Actions<2>& actions) {
  ElementOptions options;
  options.order = "quadratic";
  return Element<2>({half_arch(), LawChoice("saint-venant-kirchhoff"), {E, 0, 1000}}, options, actions);
}

/// A downward force of 1 N on the upper node of the middle.
Actions<2> loaded() {
  const Cloud<2> cloud = half_arch();
  Actions<2> actions;
  actions.held = {holding_ends(cloud)};
  SurfaceLoad<2> load;
  load.name = "middle";
  load.steady = true;
  load.traction = [](const Vec<2>&, const Vec<2>&, double) -> Vec<2> { return {0, -1}; };
  // quadratic elements take 2/3 of the area of such a node
  load.places = {{middle_nodes(cloud).back(), cloud.X[middle_nodes(cloud).back()], 1.5 * Vec<2>::UnitY()}};
  actions.surface = {load};
  return actions;
}

/// The force that holds the same node at that displacement.
double force_at(double u_y) {
  const Cloud<2> cloud = half_arch();
  Actions<2> actions;
  actions.held = {holding_ends(cloud)};
  Held<2> pushed{"pushed", {}, [=](const Vec<2>&, int, double) { return HeldMotion{u_y, 0, 0}; }};
  pushed.places = {{middle_nodes(cloud).back(), 1, cloud.X[middle_nodes(cloud).back()]}};
  actions.held.push_back(pushed);
  const Element<2> body = arch(actions);
  BodyMotion motion{VectorXd::Zero(2 * cloud.size()), VectorXd::Zero(2 * cloud.size())};
  ImplicitOptions options;
  options.steps = 64;
  const auto result = find_equilibrium<2>(body.stored_energy(), body.actions(), 1, options, motion);
  EXPECT_TRUE(result.completed());
  return -result.reactions[1].force[1];
}

TEST(ArcLength, FollowsAnArchThroughItsLimitPoints) {
  const Actions<2> actions = loaded();
  const Element<2> body = arch(actions);
  const StoredEnergy<2> energy = body.stored_energy();
  ArcLengthPath<2> path(energy, body.actions());
  const Index pushed = 2 * middle_nodes(body.body().cloud).back() + 1;
  std::vector<ArcPoint> points{path.point()};
  double work = 0;
  for (int n = 0; n < 1000 && points.back().u[pushed] > -2.4 * rise; ++n) {
    const auto next = path.step(0.01);
    ASSERT_TRUE(next) << n << ": load " << points.back().load << ", u " << points.back().u[pushed];
    work -= 0.5 * (next->load + points.back().load) * (next->u[pushed] - points.back().u[pushed]);
    points.push_back(*next);
  }
  EXPECT_LT(points.back().u[pushed], -2.4 * rise);  // it has snapped through
  double most = 0, least = 1e9;
  for (const ArcPoint& p : points) {
    most = std::max(most, p.u[pushed] > -rise ? p.load : 0);
    if (p.u[pushed] < -rise) least = std::min(least, p.load);
  }
  EXPECT_GT(most, 1.5 * least);                // a limit point, and a lower one behind it
  EXPECT_GT(points.back().load, 1.5 * least);  // and up again
  // up to the limit point and far behind the lower one, each point is the equilibrium under that displacement
  for (const std::size_t n : {points.size() / 6, points.size() - 1})
    EXPECT_NEAR(points[n].load, force_at(points[n].u[pushed]), 1e-6 * most) << n;
  // in between too the work of the load on any small motion is the change of the energy; held displacements find another
  // equilibrium there, of less energy
  for (const std::size_t n : {points.size() / 6, points.size() / 3, points.size() / 2, points.size() - 1}) {
    VectorXd w(points[n].u.size());
    for (Index k = 0; k < w.size(); ++k) w[k] = std::sin(12.9898 * static_cast<double>(k + 1));
    for (const HeldPlace<2>& place : actions.held[0].places) w[2 * place.particle + place.component] = 0;
    const double e = 1e-7;  // e^2 times third derivatives of E/thickness^3, and rounding of E over e
    const double slope = (energy.energy(points[n].u + e * w) - energy.energy(points[n].u - e * w)) / (2 * e);
    EXPECT_NEAR(slope, -points[n].load * w[pushed], 1e-5 * most) << n;
  }
  EXPECT_NEAR(work, energy.energy(points.back().u), 0.01 * work);  // trapezia of some 50 steps
}

TEST(ArcLength, RefusesWhatItCannotFollow) {
  Actions<2> actions = loaded();
  actions.surface[0].steady = false;
  const Element<2> varying = arch(actions);
  EXPECT_THROW(ArcLengthPath<2>(varying.stored_energy(), varying.actions()), InputError);
  actions.surface.clear();
  const Element<2> bare = arch(actions);
  EXPECT_THROW(ArcLengthPath<2>(bare.stored_energy(), bare.actions()), InputError);
}

}  // namespace
}  // namespace plumb
