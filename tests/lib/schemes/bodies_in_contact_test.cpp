// Two bodies in the schemes updated and eulerian: collisions, slides, neighbours that do not touch.
#include "lib/core/error.hpp"
#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/point_fields.hpp"
#include "lib/schemes/updated/updated.hpp"
#include "tests/support/moving_bodies.hpp"

namespace plumb::testing {
namespace {

const Elastic pliant{1e6, 0, 1000};  // c = 31.6 m/s
const double wave = std::sqrt(1000.0);

template <class Scheme>
typename Scheme::Options without_damping() {
  typename Scheme::Options o;
  if constexpr (requires { o.dissipation; })
    o.dissipation = "none";
  else
    o.damping = "none";
  return o;
}

template <int d, class Scheme>
Scheme in_contact(const Cloud<d>& cloud, const typename Scheme::Options& options, double friction = 0,
                  const Actions<d>& actions = {}) {
  return Scheme({cloud, LawChoice("linear-elastic"), pliant}, options, actions, 0, {},
                {{}, {0, friction, friction, 0}});
}

/// Both clouds as two bodies.
template <int d>
Cloud<d> joined(Cloud<d> first, const Cloud<d>& second) {
  first.line = 0;
  first.body.assign(first.X.size(), 0);
  first.X.insert(first.X.end(), second.X.begin(), second.X.end());
  first.V.insert(first.V.end(), second.V.begin(), second.V.end());
  first.body.resize(first.X.size(), 1);
  return first;
}

template <int d>
Cloud<d> box_at(const Vec<d>& origin, std::array<Index, d> count, double spacing) {
  Vec<d> size;
  for (int k = 0; k < d; ++k) size[k] = spacing * static_cast<double>(count[k]);
  return lattice<d>({origin, size}, count, Layout::cell);
}

/// Mean velocity of one of the bodies.
template <int d, class State>
Vec<d> mean_velocity(const Cloud<d>& cloud, const State& state, int body) {
  Vec<d> sum = Vec<d>::Zero();
  double volume = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    if (cloud.body[i] == body) {
      sum += cloud.V[i] * vector_at<d>(state.v, i);
      volume += cloud.V[i];
    }
  return sum / volume;
}

struct Collision {
  double quarter = -1, most = -1;  ///< when the second bar has that share of its speed [s]
  double speed = 0, kept = 0, work = 0;
};

/// A bar of 1 m that flies into an equal one at rest with c/1000.
template <int d, class Scheme>
Collision collide(double spacing, double dt, double end) {
  const auto n = static_cast<Index>(std::lround(1 / spacing));
  std::array<Index, d> count;
  count.fill(6);
  count[0] = n;
  Vec<d> left = Vec<d>::Zero();
  left[0] = -1;
  const Cloud<d> cloud =
      joined<d>(box_at<d>(left, count, spacing), box_at<d>(Vec<d>::Zero(), count, spacing));
  auto scheme = in_contact<d, Scheme>(cloud, without_damping<Scheme>());
  const double speed = 1e-3 * wave;
  auto state = scheme.start(
      moving<d>(cloud, [&](const Vec<d>& X) { return Vec<d>((X[0] < 0 ? speed : 0) * Vec<d>::Unit(0)); }));
  Collision seen;
  const double before = scheme.energy(state).total();
  while (state.time < end) {
    EXPECT_FALSE(scheme.advance(state, dt));
    const double share = mean_velocity<d>(cloud, state, 1)[0] / speed;
    if (seen.quarter < 0 && share > 0.25) seen.quarter = state.time;
    if (seen.most < 0 && share > 0.75) seen.most = state.time;
    seen.speed = share;
  }
  seen.kept = scheme.energy(state).total() / before;
  seen.work = state.outside.contact / before;
  return seen;
}

/// Equal bars exchange their velocities in the time 2 L/c: the pressure between them is constant for so long, and half of
/// it lies between a quarter and three quarters of the speed.
template <class Scheme1, class Scheme2>
void bars_exchange_their_velocities() {
  const Collision line = collide<1, Scheme1>(0.02, 2e-4, 4 / wave);
  EXPECT_NEAR((line.most - line.quarter) * wave, 1, 0.03);
  EXPECT_NEAR(line.speed, 1, 0.03);  // waves of single spacings stay behind
  EXPECT_NEAR(line.kept, 1, 1e-3);
  EXPECT_NEAR(line.work, 0, 1e-3);  // what the penalty stored is back
  const Collision plane = collide<2, Scheme2>(0.05, 4e-4, 4 / wave);
  EXPECT_NEAR((plane.most - plane.quarter) * wave, 1, 0.08);
  EXPECT_NEAR(plane.speed, 1, 0.05);
}
TEST(BodiesInContact, ExchangeTheirVelocities) {
  bars_exchange_their_velocities<Updated<1>, Updated<2>>();
  bars_exchange_their_velocities<Eulerian<1>, Eulerian<2>>();
}

/// What a collision without friction changes of the energy falls with the square of the step.
template <class Scheme>
void a_collision_keeps_its_energy() {
  double lost[2];
  for (int k = 0; k < 2; ++k) lost[k] = std::abs(collide<1, Scheme>(0.05, 8e-4 / (k + 1), 0.2).kept - 1);
  EXPECT_LT(lost[0], 1e-2);
  EXPECT_LT(lost[1], 0.4 * lost[0] + 1e-5);
}
TEST(BodiesInContact, KeepTheEnergyOfACollision) {
  a_collision_keeps_its_energy<Updated<1>>();
  a_collision_keeps_its_energy<Eulerian<1>>();
}

/// A block that spins beside another one at rest, nearer than the reach of the kernel but without touching it: nothing happens.
/// As one body they are glued by the sums.
template <class Scheme>
void a_neighbour_stays_at_rest() {
  const Cloud<2> cloud = joined<2>(box_at<2>({0, 0}, {8, 8}, 0.125), box_at<2>({1.1, 0.25}, {4, 4}, 0.125));
  for (const bool two : {true, false}) {
    Cloud<2> bodies = cloud;
    if (!two) bodies.body.clear();
    auto scheme = in_contact<2, Scheme>(bodies, {});
    auto state = scheme.start(moving<2>(
        cloud, [](const Vec<2>& X) { return X[0] < 1.05 ? Vec<2>(0, 0) : Vec<2>(0.5 - X[1], X[0] - 1.35); }));
    for (int n = 0; n < 20; ++n) ASSERT_FALSE(scheme.advance(state, 1e-3));
    double most = 0;
    for (Index i = 0; i < 64; ++i) most = std::max(most, vector_at<2>(state.v, i).norm());
    if (two)
      EXPECT_LT(most, 1e-14);  // rounding of deformation gradients
    else
      EXPECT_GT(most, 1e-3);
  }
}
TEST(BodiesInContact, LeaveANeighbourAloneThatTheyDoNotTouch) {
  a_neighbour_stays_at_rest<Updated<2>>();
  a_neighbour_stays_at_rest<Eulerian<2>>();
}

/// A block on a held floor, pressed on it by its weight, which sits down while the weight grows, is slowed down by mu g.
template <class Scheme>
void a_block_slides(double mu) {
  constexpr double dp = 0.0625, g = 10, speed = 2, ramp = 0.05, end = 0.2;
  const Cloud<2> cloud = joined<2>(box_at<2>({0, -4 * dp}, {32, 4}, dp), box_at<2>({0.25, 0}, {8, 4}, dp));
  Actions<2> actions;
  Held<2> held;
  held.name = "floor";
  held.motion = [](const Vec<2>&, int, double) { return HeldMotion{}; };
  for (Index i = 0; i < cloud.size(); ++i)
    if (cloud.body[i] == 0)
      for (int k = 0; k < 2; ++k) held.places.push_back({i, k, cloud.X[i]});
  actions.held.push_back(held);
  BodyForce<2> weight;
  weight.name = "gravity";
  weight.per_volume = [](const Vec<2>&, double t) { return Vec<2>(0, -1000 * g * std::min(1.0, t / ramp)); };
  weight.steady = false;
  actions.body_forces.push_back(weight);
  auto scheme = in_contact<2, Scheme>(cloud, {}, mu, actions);
  auto state = scheme.start(
      moving<2>(cloud, [&](const Vec<2>& X) { return X[1] < 0 ? Vec<2>(0, 0) : Vec<2>(speed, 0); }));
  while (state.time < end - 1e-9) ASSERT_FALSE(scheme.advance(state, 5e-4));
  const double slowed = speed - mean_velocity<2>(cloud, state, 1)[0];
  EXPECT_NEAR(slowed / (g * (end - 0.5 * ramp)), mu, mu > 0 ? 0.05 * mu : 1e-3);
  const double mass = 1000 * 32 * dp * dp;
  EXPECT_NEAR(state.outside.contact / (0.5 * mass * speed * speed),
              std::pow(1 - mu * g * (end - 0.5 * ramp) / speed, 2) - 1, 0.02);
}
TEST(BodiesInContact, AreSlowedDownByMuTimesTheirWeight) {
  for (const double mu : {0.0, 0.25}) {
    a_block_slides<Updated<2>>(mu);
    a_block_slides<Eulerian<2>>(mu);
  }
}

/// Blocks that slide along each other when they meet: both momenta to round-off, and friction takes speed along their faces.
template <class Scheme>
void momenta_of_a_collision() {
  const Cloud<2> cloud =
      joined<2>(box_at<2>({0, 0}, {8, 8}, 0.0625), box_at<2>({0.51, 0.03}, {8, 8}, 0.0625));
  double turned[2];
  for (const bool rough : {false, true}) {
    auto scheme = in_contact<2, Scheme>(cloud, {}, rough ? 0.4 : 0);
    auto state = scheme.start(
        moving<2>(cloud, [](const Vec<2>& X) { return X[0] < 0.505 ? Vec<2>(3, 0) : Vec<2>(0, 1); }));
    const BodySums<2> before = body_sums<2>(scheme.snapshot(state));
    for (int n = 0; n < 150; ++n) ASSERT_FALSE(scheme.advance(state, 4e-4));
    const BodySums<2> after = body_sums<2>(scheme.snapshot(state));
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-13 * before.momentum_scale);
    EXPECT_LT(std::abs(after.spin - before.spin), 1e-12 * before.momentum_scale);
    EXPECT_GT(mean_velocity<2>(cloud, state, 1)[0], 0.5);
    turned[rough] = mean_velocity<2>(cloud, state, 1)[1];
  }
  EXPECT_NEAR(turned[0], 1, 0.1);                  // an edge stands before a face
  EXPECT_NEAR(turned[0] - turned[1], 0.16, 0.05);  // 0.2 where faces of stiff blocks stick at last
}
TEST(BodiesInContact, KeepBothMomentaInAnObliqueCollision) {
  momenta_of_a_collision<Updated<2>>();
  momenta_of_a_collision<Eulerian<2>>();
}

TEST(BodiesInContact, AreNotOfThePrintedBalance) {
  const Cloud<1> cloud = joined<1>(box_at<1>(Vec<1>(0.0), {8}, 0.1), box_at<1>(Vec<1>(1.0), {8}, 0.1));
  UpdatedOptions o;
  o.balance = "printed";
  EXPECT_THROW((in_contact<1, Updated<1>>(cloud, o)), InputError);
}

}  // namespace
}  // namespace plumb::testing
