// Blue noise in a box: random particles that keep a distance and leave no hole, with the nodes of the lattice
// on the faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/geometry/poisson_discs.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

/// Least distance of the discs in spacings.
template <int d>
constexpr double disc = d == 2 ? 0.81 : 0.89;
template <int d>
constexpr Index across = d == 2 ? 20 : 9;

/// In a box of unequal sides off the origin.
template <int d>
Shape<d> box() {
  Shape<d> shape{{Vec<d>::Constant(-0.3), Vec<d>::Constant(static_cast<double>(across<d>))}, {}};
  shape.box.size[0] -= 2;
  return shape;
}

template <int d>
Cloud<d> blue_noise(double spacing, std::uint64_t seed = 1) {
  return shaped_cloud<d>(box<d>(), {spacing, Layout::node, true, 0, seed});
}

template <int d>
bool on_face(const Cloud<d>& cloud, const Vec<d>& X) {
  const Vec<d> lower = X - cloud.box.origin, upper = lower - cloud.box.size;
  return (lower.array() == 0 || upper.array() == 0).any();
}

template <class Case>
class BlueNoise : public ::testing::Test {};
using Kinds = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(BlueNoise, Kinds, test::Names);

TYPED_TEST(BlueNoise, KeepsItsDistance) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = blue_noise<d>(1);
  for (Index i = 0; i < cloud.size(); ++i)
    for (Index j = 0; j < i; ++j) EXPECT_GE((cloud.X[i] - cloud.X[j]).norm(), disc<d>);
}

// A hole in which discs of centres within x of its middle would fit survives n throws per spacing^d with
// exp(-n pi x^2) or exp(-n 4/3 pi x^3): n = 300 leaves one in a thousand of these clouds with x = 0.12 or
// 0.23.
TYPED_TEST(BlueNoise, LeavesNoHole) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = blue_noise<d>(1);
  RandomNumbers random(9);
  double widest = 0;
  for (int n = 0; n < (d == 2 ? 20000 : 30000);
       ++n) {  // some 50 per spacing^d: none is missed by more than 0.1
    const Vec<d> at = random.in(cloud.box);
    double nearest = 1e9;
    for (const auto& X : cloud.X) nearest = std::min(nearest, (X - at).norm());
    widest = std::max(widest, nearest);
  }
  EXPECT_LT(widest, disc<d> + (d == 2 ? 0.12 : 0.23));
  EXPECT_GT(widest, 0.8 * disc<d>);  // or the particles are crowded
}

// Exact displacements can be prescribed there.
TYPED_TEST(BlueNoise, HasTheNodesOfTheLatticeOnItsFaces) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = blue_noise<d>(1);
  const Cloud<d> nodes = lattice<d>(cloud.box, cells_of<d>(cloud.box, 1), Layout::node);
  const auto sorted_faces = [](const Cloud<d>& c) {
    std::vector<std::array<double, d>> found;
    for (const auto& X : c.X)
      if (on_face(c, X)) {
        found.emplace_back();
        for (int k = 0; k < d; ++k) found.back()[k] = std::round(1e9 * X[k]);
      }
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(sorted_faces(cloud), sorted_faces(nodes));
}

TYPED_TEST(BlueNoise, HasOneParticlePerSpacing) {
  constexpr int d = TypeParam::d;
  for (const double spacing : {1.0, 0.5}) {
    const Cloud<d> cloud = blue_noise<d>(spacing);
    const Cloud<d> nodes = lattice<d>(cloud.box, cells_of<d>(cloud.box, spacing), Layout::node);
    EXPECT_NEAR(static_cast<double>(cloud.size()) / static_cast<double>(nodes.size()), 1, 0.06);
  }
}

TYPED_TEST(BlueNoise, FillsTheBox) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = blue_noise<d>(1);
  const double sum = std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0);
  EXPECT_NEAR(sum / cloud.box.size.prod(), 1, 1e-12);  // sums of some hundred cells
  EXPECT_GT(*std::min_element(cloud.V.begin(), cloud.V.end()), 0);
}

TYPED_TEST(BlueNoise, IsTheSameForTheSameSeed) {
  constexpr int d = TypeParam::d;
  const Cloud<d> one = blue_noise<d>(1, 4), again = blue_noise<d>(1, 4), other = blue_noise<d>(1, 5);
  EXPECT_EQ(one.X, again.X);
  EXPECT_EQ(one.V, again.V);
  EXPECT_NE(one.X, other.X);
}

}  // namespace
}  // namespace plumb
