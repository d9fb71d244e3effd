// Signed distances and boxes of every shape at points worked out by hand, inside, outside, beside edges and
// corners; of what holes leave; and places and volumes of lattices whose axes are all different.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/geometry/cloud.hpp"
#include "lib/geometry/shape.hpp"

namespace plumb {
namespace {

template <int d>
void expect_distance(const Shape<d>& shape, const Vec<d>& X, double expected) {
  EXPECT_NEAR(shape.distance(X), expected, 1e-14) << X.transpose();
}

TEST(ShapeValues, OfABox) {
  const auto box = shape_named<2>("box", {{"origin", {1, 2}}, {"size", {4, 2}}});
  EXPECT_EQ(box.box.origin, Vec<2>(1, 2));
  EXPECT_EQ(box.box.size, Vec<2>(4, 2));
  expect_distance<2>(box, {2, 3.75}, -0.25);
  expect_distance<2>(box, {1.1, 3}, -0.1);
  expect_distance<2>(box, {3, 5}, 1);
  expect_distance<2>(box, {8, 8}, 5);  // beyond the corner (5, 4) by 3 and 4
  expect_distance<2>(box, {-2, -2}, 5);
  const auto hole = without(shape_named<2>("box", {{"size", {10, 10}}}), box);
  expect_distance<2>(hole, {2, 3.75}, 0.25);
  expect_distance<2>(hole, {5.5, 3}, -0.5);
  expect_distance<2>(hole, {9.8, 9}, -0.2);
  const auto solid = shape_named<3>("box", {{"origin", {0, 0, 1}}, {"size", {1, 2, 3}}});
  expect_distance<3>(solid, {0.4, 0.9, 1.3}, -0.3);
  expect_distance<3>(solid, {2, 4, 6}, 3);  // 1, 2, 2 beyond
}

TEST(ShapeValues, OfBallAnnulusAndCylinder) {
  const auto ball = shape_named<3>("ball", {{"centre", {1, 2, 3}}, {"radius", {5}}});
  expect_distance<3>(ball, {2, 4, 5}, -2);
  expect_distance<3>(ball, {1, 2, 9}, 1);
  EXPECT_EQ(ball.box.origin, Vec<3>(-4, -3, -2));
  EXPECT_EQ(ball.box.size, Vec<3>(10, 10, 10));
  const auto ring = shape_named<2>("annulus", {{"centre", {1, 1}}, {"inner", {2}}, {"outer", {5}}});
  expect_distance<2>(ring, {1, 3.5}, -0.5);
  expect_distance<2>(ring, {1, 5.75}, -0.25);
  expect_distance<2>(ring, {1, 2}, 1);
  EXPECT_NEAR(ring.clip({4, 5.5}), std::sqrt(9 + 20.25) - 5, 1e-14);
  EXPECT_EQ(ring.box.origin, Vec<2>(-4, -4));
  EXPECT_EQ(ring.box.size, Vec<2>(10, 10));
  const auto cylinder = shape_named<3>("cylinder", {{"centre", {1, 2, 3}}, {"radius", {5}}, {"length", {4}}});
  EXPECT_EQ(cylinder.box.origin, Vec<3>(-4, -3, 1));
  EXPECT_EQ(cylinder.box.size, Vec<3>(10, 10, 4));
  expect_distance<3>(cylinder, {4, 6, 3}, 0);
  expect_distance<3>(cylinder, {1, 5, 4.75}, -0.25);  // its end is nearer
  expect_distance<3>(cylinder, {1, 5.5, 3}, -1.5);
}

TEST(ShapeValues, OfPolygonAndHalfSpace) {
  const auto triangle = shape_named<2>("polygon", {{"corners", {0, 0, 4, 0, 0, 3}}});
  // the legs lie on faces of the box, which cuts there; the clip is that of the long edge 3x + 4y = 12
  EXPECT_NEAR(triangle.clip({1, 0.5}), (3 + 2 - 12) / 5.0, 1e-14);
  EXPECT_NEAR(triangle.clip({0.25, 1}), (0.75 + 4 - 12) / 5.0, 1e-14);
  EXPECT_NEAR(triangle.clip({2, 2}), 0.4, 1e-14);  // from the long edge 3x + 4y = 12: (6 + 8 - 12)/5
  EXPECT_NEAR(triangle.clip({-3, -4}), (-9 - 16 - 12) / 5.0, 1e-14);
  EXPECT_NEAR(triangle.clip({7, -4}), 5, 1e-14);
  const auto inward = shape_named<2>("polygon", {{"corners", {0, 0, 4, 0, 4, 4, 2, 1, 0, 4}}});
  EXPECT_GT(inward.clip({2, 2}), 0);
  EXPECT_LT(inward.clip({2, 0.9}), 0);
  const auto half = shape_named<2>("half-space", {{"point", {1, 1}}, {"normal", {3, 4}}});
  EXPECT_NEAR(half.clip({4, 5}), -5, 1e-14);
  EXPECT_NEAR(half.clip({1, -4}), 4, 1e-14);
  EXPECT_FALSE(half.box.size.allFinite());
}

/// Every particle of a lattice by its place along each axis, whatever axis runs fastest.
template <int d>
void expect_lattice(const Vec<d>& size, const std::array<Index, d>& cells, Layout layout) {
  const Box<d> box{Vec<d>::Constant(-0.3), size};
  const Cloud<d> cloud = lattice<d>(box, cells, layout);
  const bool node = layout == Layout::node;
  double cell = 1;
  Index total = 1;
  for (int k = 0; k < d; ++k) {
    cell *= size[k] / static_cast<double>(cells[k]);
    total *= cells[k] + node;
    EXPECT_EQ(cloud.count[k], cells[k] + node);
  }
  ASSERT_EQ(cloud.size(), total);
  EXPECT_NEAR(cloud.spacing, std::pow(cell, 1.0 / d), 1e-15);
  for (Index n = 0; n < total; ++n) {
    double volume = cell;
    for (int k = 0; k < d; ++k) {
      const Index place = n / cloud.stride[k] % cloud.count[k];
      const double step = size[k] / static_cast<double>(cells[k]);
      EXPECT_NEAR(cloud.X[n][k], -0.3 + (static_cast<double>(place) + (node ? 0 : 0.5)) * step, 1e-14);
      if (node && (place == 0 || place == cells[k])) volume /= 2;
    }
    EXPECT_NEAR(cloud.V[n], volume, 1e-15);
  }
}

TEST(LatticeValues, OfUnequalAxes) {
  for (const Layout layout : {Layout::cell, Layout::node}) {
    expect_lattice<1>(Vec<1>(1.4), {7}, layout);
    expect_lattice<2>({0.6, 1.5}, {3, 5}, layout);
    expect_lattice<3>({0.6, 1.5, 1.6}, {3, 5, 4}, layout);
    expect_lattice<3>({1.6, 0.6, 1.5}, {4, 3, 5}, layout);
  }
}

}  // namespace
}  // namespace plumb
