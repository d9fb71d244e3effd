// Forces between bodies: their potential, momenta, pressure and friction, without any scheme.
#include "lib/schemes/touching_bodies.hpp"

#include <Eigen/Geometry>  // cross

#include "lib/core/error.hpp"
#include "lib/schemes/point_fields.hpp"
#include "tests/support/moving_bodies.hpp"

namespace plumb::testing {
namespace {

constexpr double touch_dp = 0.1, touch_modulus = 2e6;

/// Two boxes of one cloud: the second one beside the first along the last axis, so that their surfaces are `gap` spacings apart,
/// and moved along the first axis by `along` spacings.
template <int d>
Cloud<d> two_boxes(std::array<Index, d> count, double gap, double along = 0) {
  Cloud<d> all = cells<d>(count, touch_dp);
  const Cloud<d> other = all;
  Vec<d> shift = Vec<d>::Zero();
  if (d > 1) shift[0] = along * touch_dp;
  shift[d - 1] += (static_cast<double>(count[d - 1]) + gap) * touch_dp;
  all.line = 0;
  all.body.assign(all.X.size(), 0);
  for (std::size_t i = 0; i < other.X.size(); ++i) {
    all.X.push_back(other.X[i] + shift);
    all.V.push_back(other.V[i]);
    all.body.push_back(1);
  }
  return all;
}

template <int d>
struct AtRest {
  std::vector<Vec<d>> v;
  std::vector<Mat<d>> L;
  explicit AtRest(const Cloud<d>& cloud)
      : v(cloud.X.size(), Vec<d>::Zero()), L(cloud.X.size(), Mat<d>::Zero()) {}
  SurfaceMotion<d> motion(double time = 0) const { return {v, L, time}; }
};

/// Pressure on the middle particle of the second box.
template <int d>
double pressure_at(std::array<Index, d> count, double gap, double along) {
  const Cloud<d> cloud = two_boxes<d>(count, gap, along);
  TouchingBodies<d> bodies(cloud, touch_modulus, {});
  Field none;
  bodies.find(cloud.X, AtRest<d>(cloud).motion(), none);
  Vec<d> middle = Vec<d>::Zero();
  middle[0] = d > 1 ? along * touch_dp : 0;
  double sum = 0;  // of its column, since deeper layers feel a little, too
  for (Index i = cloud.size() / 2; i < cloud.size(); ++i) {
    bool in_column = true;
    for (int k = 0; k < d - 1; ++k)
      in_column = in_column && std::abs(cloud.X[i][k] - middle[k]) < 0.51 * touch_dp;
    if (in_column) sum += bodies.forces()[i][d - 1];
  }
  return sum / std::pow(touch_dp, d - 1);
}

/// What touches does not press; a layer of one spacing with the modulus E* does, wherever the particles of the other stand.
TEST(TouchingBodies, PressWithTheirGap) {
  EXPECT_EQ(pressure_at<1>({8}, 0, 0), 0);
  EXPECT_NEAR(pressure_at<1>({8}, -1e-3, 0) / (1e-3 * touch_modulus), 1, 2e-3);
  EXPECT_EQ(pressure_at<2>({9, 4}, 0.01, 0.3), 0);
  const std::array<Index, 3> cube{9, 9, 4};
  for (const double along : {0.0, 0.25, 0.5}) {
    // the slope of (19.3) grows with the depth, by 6.2 % here; ripples of 1e-4 and 3e-4 of a spacing in the gap
    EXPECT_NEAR(pressure_at<2>({17, 4}, -0.05, along) / (0.05 * touch_modulus), 1.062, 0.01) << along;
    EXPECT_NEAR(pressure_at<3>(cube, -0.05, along) / (0.05 * touch_modulus), 1.062, 0.01) << along;
  }
}

/// Two jittered boxes that are pressed into each other, and turned against each other in 2D.
template <int d>
Cloud<d> rough_pair() {
  std::array<Index, d> count;
  count.fill(4);
  Cloud<d> cloud = two_boxes<d>(count, -0.25, 0.4);
  test::Numbers numbers(5);
  for (Vec<d>& X : cloud.X) X += 0.1 * touch_dp * numbers.template vector<d>();
  return cloud;
}

template <int d>
void forces_are_slopes() {
  const Cloud<d> cloud = rough_pair<d>();
  TouchingBodies<d> bodies(cloud, touch_modulus, {});
  Field none;
  bodies.find(cloud.X, AtRest<d>(cloud).motion(), none);
  const std::vector<Vec<d>> forces = bodies.forces();
  double most = 0;
  for (const Vec<d>& f : forces) most = std::max(most, f.norm());
  ASSERT_GT(most, 0);
  const double e =
      1e-5 * touch_dp;  // differences of second order of energies with kinks of third order: 1e-6
  std::vector<Vec<d>> x = cloud.X;
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; k < d; ++k) {
      x[i][k] += e;
      const double above = bodies.stored(x);
      x[i][k] -= 2 * e;
      const double below = bodies.stored(x);
      x[i][k] = cloud.X[i][k];
      ASSERT_NEAR(forces[i][k], -(above - below) / (2 * e), 2e-5 * most) << i << k;
    }
}
TEST(TouchingBodies, PenaltiesHaveAPotential) {
  forces_are_slopes<1>();
  forces_are_slopes<2>();
  forces_are_slopes<3>();
}

/// Sum of forces, and of their torques with the couples, whose skew part turns a particle.
template <int d>
void momenta_are_kept() {
  const Cloud<d> cloud = rough_pair<d>();
  TouchingBodies<d> bodies(cloud, touch_modulus, {0, 0.3, 0.3, 0});
  AtRest<d> moves(cloud);
  test::Numbers numbers(9);
  for (Vec<d>& v : moves.v) v = numbers.template vector<d>();
  for (Mat<d>& L : moves.L)
    for (int n = 0; n < d * d; ++n) L(n / d, n % d) = numbers.next();
  Field slip(d, cloud.size(), 0);
  bodies.find(cloud.X, moves.motion(0.01), slip);
  ASSERT_NE(bodies.couples(), nullptr);
  Vec<d> force = Vec<d>::Zero();
  Mat<d> torque = Mat<d>::Zero();
  double scale = 0, couples = 0, rubbed = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    force += bodies.forces()[i];
    scale += bodies.forces()[i].norm();
    // f at c is f at x and f (x) (c - x): the couple of the stress is minus its sum
    const Mat<d> arm = bodies.forces()[i] * cloud.X[i].transpose() - (*bodies.couples())[i];
    torque += arm - arm.transpose();
    couples += (*bodies.couples())[i].norm();
    rubbed += vector_at<d>(slip, i).norm();
  }
  EXPECT_LT(force.norm(), 1e-14 * scale);
  EXPECT_LT(torque.norm(), 1e-13 * scale * touch_dp * 10);
  EXPECT_GT(couples, 1e-3 * scale * touch_dp);
  EXPECT_GT(rubbed, 0);
}
TEST(TouchingBodies, FrictionKeepsBothMomenta) {
  momenta_are_kept<2>();
  momenta_are_kept<3>();
}

/// Friction is mu times the pressure where a body slides, and less where it has slid a little; a call without time changes nothing.
TEST(TouchingBodies, FrictionHasCoulombsLimit) {
  const Cloud<2> cloud = two_boxes<2>({9, 4}, -0.1, 0.3);
  const double mu = 0.3;
  TouchingBodies<2> bodies(cloud, touch_modulus, {0, mu, mu, 0}), smooth(cloud, touch_modulus, {});
  AtRest<2> moves(cloud);
  Field slip(2, cloud.size(), 0), none;
  smooth.find(cloud.X, moves.motion(), none);
  for (Index i = cloud.size() / 2; i < cloud.size(); ++i) moves.v[i] = {1, 0.2};
  const auto on_second = [&] {
    Vec<2> sum = Vec<2>::Zero();
    for (Index i = cloud.size() / 2; i < cloud.size(); ++i) sum += bodies.forces()[i] - smooth.forces()[i];
    return sum;
  };
  double pressed = 0;
  for (Index i = cloud.size() / 2; i < cloud.size(); ++i) pressed += smooth.forces()[i][1];
  bodies.find(cloud.X, moves.motion(1e-7), slip);
  const double little = on_second()[0];
  bodies.find(cloud.X, moves.motion(1e-7), slip);
  EXPECT_NEAR(on_second()[0] / little, 2, 1e-6);
  EXPECT_LT(std::abs(little), 0.02 * mu * pressed);
  for (int n = 0; n < 3; ++n) {
    bodies.find(cloud.X, moves.motion(n == 2 ? 0 : 1), slip);
    // normals of single particles lean by a few degrees at the ends of the smaller box
    EXPECT_NEAR(-on_second()[0] / (mu * pressed), 1, 0.03);
  }
}

TEST(TouchingBodies, RefuseWhatOverlaps) {
  EXPECT_THROW(TouchingBodies<2>(two_boxes<2>({4, 4}, -0.6), touch_modulus, {}), InputError);
}

}  // namespace
}  // namespace plumb::testing
