#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "lib/geometry/shaped_cloud.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"

namespace plumb {
namespace {

Shape<2> polygon(const std::vector<double>& corners) {
  return shape_named<2>("polygon", {{"corners", corners}});
}

// Cook's membrane [mm]: two vertical sides on faces of its box, two slanted ones.
const std::vector<double> cook{0, 0, 48, 44, 48, 60, 0, 44};

TEST(Polygon, ARectangleIsABox) {
  const Shape<2> shape = polygon({0, 0, 1, 0, 1, 0.5, 0, 0.5});
  EXPECT_FALSE(shape.clip);
  EXPECT_EQ(shape.box.origin, Vec<2>(0, 0));
  EXPECT_EQ(shape.box.size, Vec<2>(1, 0.5));
  EXPECT_TRUE(polygon({0, 0, 1, 0, 1, 0.5, 0, 0.4}).clip);
}

TEST(Polygon, ItsBoxIsThatOfItsCorners) {
  const Shape<2> shape = polygon(cook);
  EXPECT_EQ(shape.box.origin, Vec<2>(0, 0));
  EXPECT_EQ(shape.box.size, Vec<2>(48, 60));
}

// Of every shape: the box touches the body on every side.
TEST(Shapes, TheBoxIsTheSmallestOne) {
  const auto touches = []<int d>(const Shape<d>& shape, int axis, double face) {
    double least = 1e9;
    const int n = 200;
    for (int i = 0; i <= n; ++i)
      for (int k = 0; k <= (d == 3 ? n : 0); ++k) {
        Vec<d> X = shape.box.origin + (static_cast<double>(i) / n) * shape.box.size;
        if constexpr (d == 3)
          X[(axis + 2) % d] = shape.box.origin[(axis + 2) % d] + k * shape.box.size[(axis + 2) % d] / n;
        X[axis] = face;
        least = std::min(least, shape.distance(X));
      }
    return std::abs(least) < 1e-9;
  };
  const std::map<std::string, ShapeLengths> all{
      {"box", {{"origin", {1, 2}}, {"size", {3, 4}}}},
      {"ball", {{"centre", {1, 2}}, {"radius", {3}}}},
      {"annulus", {{"centre", {1, 2}}, {"inner", {1}}, {"outer", {3}}}},
      {"polygon", {{"corners", cook}}}};
  for (const auto& [name, lengths] : all) {
    const Shape<2> shape = shape_named<2>(name, lengths);
    for (int axis = 0; axis < 2; ++axis)
      for (const double face : {shape.box.origin[axis], shape.box.origin[axis] + shape.box.size[axis]})
        EXPECT_TRUE(touches(shape, axis, face)) << name << ' ' << axis << ' ' << face;
  }
  const Shape<3> cylinder = shape_named<3>("cylinder", {{"radius", {1}}, {"length", {2}}});
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) EXPECT_TRUE(touches(cylinder, axis, side)) << axis;
}

TEST(Polygon, AreaAndSurfaceAreThoseOfTheOutlineInBothDirectionsAndWithTheFirstCornerRepeated) {
  std::vector<double> closed = cook, clockwise;
  closed.insert(closed.end(), {0, 0});
  for (std::size_t k = cook.size(); k > 0; k -= 2)
    clockwise.insert(clockwise.end(), {cook[k - 2], cook[k - 1]});
  const double length = std::hypot(48, 44) + 16 + std::hypot(48, 16) + 44;
  for (const auto& corners : {cook, closed, clockwise})
    for (const Layout layout : {Layout::node, Layout::cell}) {
      const Shape<2> shape = polygon(corners);
      const Cloud<2> cloud = shaped_cloud<2>(shape, {.spacing = 2, .layout = layout});
      // 1e-9: rounding of clipped cells
      EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 1440, 1440e-9);
      double surface = 0;
      for (const auto& facet : clipped_surface<2>(cloud, shape).facets) surface += facet.area.norm();
      // pieces of one cell that make less than 45 degrees are one facet, their chord: a little shorter
      EXPECT_NEAR(surface, length, 0.02 * length);
    }
}

TEST(Polygon, TheSideIsRightOnTheBoxAndBesideAReentrantCorner) {
  // an L whose notch is the upper right quarter
  const Shape<2> shape = polygon({0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2});
  EXPECT_NEAR(shape.distance({0.5, 0.5}), -0.5, 1e-12);
  EXPECT_NEAR(shape.distance({1.5, 1.5}), 0.5, 1e-12);
  EXPECT_NEAR(shape.distance({0, 0.5}), 0, 1e-12);
  EXPECT_NEAR(shape.distance({2, 0.5}), 0, 1e-12);
  EXPECT_NEAR(shape.distance({2, 1.5}), 0.5, 1e-12);
  EXPECT_LT(shape.clip(Vec<2>(2, 0.5)), -0.4);
}

TEST(Polygon, WhatIsNoOutlineIsRefused) {
  EXPECT_THROW(polygon({0, 0, 48, 60, 48, 44, 0, 44}), InputError) << "crossing edges";
  EXPECT_THROW(polygon({0, 0, 1, 0, 0, 0}), InputError) << "two corners";
  EXPECT_THROW(polygon({0, 0, 1, 1, 2, 2}), InputError) << "no area";
  EXPECT_THROW(polygon({0, 0, 1, 0, 1, 0, 1, 1}), InputError) << "a corner twice";
  EXPECT_THROW(polygon({0, 0, 2, 0, 1, 0, 1, 1}), InputError) << "an edge that goes back";
  EXPECT_THROW(polygon({0, 0, 2, 0, 2, 2, 1, 0, 0, 2}), InputError) << "a corner on another edge";
}

}  // namespace
}  // namespace plumb
