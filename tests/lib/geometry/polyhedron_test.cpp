// Bodies within closed surfaces of triangles: distances, volumes, and what is no surface of a body.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "lib/geometry/flat_outlines.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"

namespace plumb {
namespace {

using Corners = std::vector<double>;

Shape<3> polyhedron(const Corners& corners) {
  return shape_named<3>("polyhedron", {{"corners", corners}});
}

std::string refusal(const Corners& corners) {
  try {
    polyhedron(corners);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void add(Corners& all, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  for (const Vec<3>& corner : {a, b, c}) all.insert(all.end(), corner.begin(), corner.end());
}

/// Two triangles of each face of a box, seen counterclockwise from outside.
Corners box(const Vec<3>& low, const Vec<3>& high) {
  Corners all;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Vec<3> a = low, b, c, d;
      if (upper) a[axis] = high[axis];
      b = c = d = a;
      b[u] = c[u] = high[u];
      c[v] = d[v] = high[v];
      upper ? (add(all, a, b, c), add(all, a, c, d)) : (add(all, a, c, b), add(all, a, d, c));
    }
  return all;
}

/// A corner of a cube: right angles at the origin, legs of length 1, a slanted face x + y + z = 1.
const Corners corner{0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                     0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

/// A ball of triangles between n circles of latitude.
Corners ball(double radius, int n) {
  const auto at = [&](int i, int k) {
    const double t = std::numbers::pi * i / n, p = std::numbers::pi * (k % (2 * n)) / n;
    if (i == 0 || i == n) return Vec<3>(0, 0, i == 0 ? radius : -radius);
    return Vec<3>(radius * std::sin(t) * std::cos(p), radius * std::sin(t) * std::sin(p),
                  radius * std::cos(t));
  };
  Corners all;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 2 * n; ++k) {
      if (i > 0) add(all, at(i, k), at(i + 1, k), at(i, k + 1));
      if (i + 1 < n) add(all, at(i, k + 1), at(i + 1, k), at(i + 1, k + 1));
    }
  return all;
}

Corners joined(Corners a, const Corners& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Polyhedron, ABoxIsABox) {
  const Shape<3> shape = polyhedron(box({1, 2, 3}, {2, 4, 6}));
  EXPECT_FALSE(shape.clip);
  EXPECT_EQ(shape.box.origin, Vec<3>(1, 2, 3));
  EXPECT_EQ(shape.box.size, Vec<3>(1, 2, 3));
}

TEST(Polyhedron, DistancesFromFacesEdgesAndCorners) {
  const Shape<3> shape = polyhedron(corner);
  const double root = std::sqrt(3.0);
  EXPECT_NEAR(shape.clip({0.2, 0.2, 0.2}), -0.4 / root, 1e-14);
  EXPECT_NEAR(shape.clip({1, 1, 1}), 2 / root, 1e-14);
  EXPECT_NEAR(shape.clip({0.5, 0.5, -1}), 1, 1e-14) << "beside the middle of an edge";
  EXPECT_NEAR(shape.distance({0.1, 0.3, 0.3}), -0.1, 1e-14) << "a face of the box is nearer";
  EXPECT_NEAR(shape.distance({0, 0.25, 0.25}), 0, 1e-12);
  EXPECT_GT(shape.distance({0.5, 0.5, 0.1}), 0.05);
  EXPECT_GT(shape.clip({3, -1, 0}), 0) << "beside a corner";
}

// By the sums of the pieces of its cells. Any side may be out in the file, and any triangle turned.
TEST(Polyhedron, VolumeAndSurfaceAreThoseOfTheTriangles) {
  Corners turned;
  for (std::size_t k = 0; k < corner.size(); k += 9) {
    const auto at = [&](std::size_t c) { return Vec<3>(corner.data() + k + 3 * c); };
    k % 18 == 0 ? add(turned, at(0), at(2), at(1)) : add(turned, at(0), at(1), at(2));
  }
  for (const Corners& corners : {corner, turned})
    for (const Layout layout : {Layout::node, Layout::cell}) {
      const Shape<3> shape = polyhedron(corners);
      const Cloud<3> cloud = shaped_cloud<3>(shape, {.spacing = 0.125, .layout = layout});
      // 1e-9: rounding of clipped cells of flat faces
      EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 1.0 / 6, 1e-9);
      Vec<3> closed = Vec<3>::Zero();
      for (const auto& facet : clipped_surface<3>(cloud, shape).facets) closed += facet.area;
      EXPECT_NEAR(closed.norm(), 0, 1e-9);
    }
}

TEST(Polyhedron, ABallOfTrianglesIsNearlyABall) {
  const int n = 12;
  const Shape<3> shape = polyhedron(ball(1, n));
  const double sagitta =
      1 - std::pow(std::cos(std::numbers::pi / (2 * n)), 2);  // of a quadrilateral's middle
  for (int k = 0; k < 200; ++k) {
    const Vec<3> X(std::sin(3.0 * k), std::cos(5.0 * k), std::sin(7.0 * k + 1));
    EXPECT_LE(std::abs(shape.clip(X) - (X.norm() - 1)), 1.5 * sagitta) << X.transpose();
  }
}

TEST(Polyhedron, AHollowIsNoneOfTheBody) {
  const Corners inner = box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  for (const Corners& corners :
       {joined(box({0, 0, 0}, {1, 1, 1}), inner), joined(inner, box({0, 0, 0}, {1, 1, 1}))}) {
    const Shape<3> shape = polyhedron(corners);
    EXPECT_NEAR(shape.distance({0.5, 0.5, 0.5}), 0.25, 1e-14);
    EXPECT_NEAR(shape.distance({0.5, 0.5, 0.2}), -0.05, 1e-14);
    const Cloud<3> cloud = shaped_cloud<3>(shape, {.spacing = 0.125});
    EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 0.875, 1e-9);
  }
}

TEST(Polyhedron, WhatIsNoSurfaceOfABodyIsRefusedWithItsPlace) {
  Corners open(corner.begin(), corner.end() - 9);
  open.insert(open.end(), {1, 0, 0, 0, 1, 0, 0, 0, 1.001});
  EXPECT_NE(refusal(open).find("open at the edge from"), std::string::npos) << refusal(open);
  EXPECT_NE(refusal(joined(corner, Corners(corner.begin(), corner.begin() + 9)))
                .find("3 triangles meet at the edge"),
            std::string::npos);
  EXPECT_NE(refusal(joined(box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.25, 0.25}, {2, 0.75, 0.75})))
                .find("meets itself: triangles"),
            std::string::npos);
  EXPECT_NE(refusal(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})))
                .find("touches itself at (1, 1, 1)"),
            std::string::npos)
      << refusal(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})));
  EXPECT_NE(
      refusal(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, 0.25}, {2, 0.75, 0.75}))).find("meets itself"),
      std::string::npos)
      << "side by side: their faces lie on each other";
  EXPECT_NE(refusal({0, 0, 0, 1, 0, 0, 0, 1, 0}).find("polyhedron of 3 corners"), std::string::npos);
  Corners flat = corner;  // the slanted face becomes a needle
  flat[27] = flat[30] = 0.5;
  flat[28] = flat[31] = 0.5;
  EXPECT_NE(refusal(flat), "");
  Corners folded;  // a fin without thickness
  add(folded, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add(folded, {0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  EXPECT_NE(refusal(joined(folded, box({2, 2, 2}, {3, 3, 3}))).find("meets itself"), std::string::npos);
}

using Triangles = std::vector<std::array<Vec<3>, 3>>;

/// A square of side 2 about the origin without the square of side 1 in its middle, of eight triangles.
Triangles frame() {
  Triangles all;
  const Vec<3> a[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec<3>&p = a[k], &q = a[(k + 1) % 4];
    all.push_back({p, q, Vec<3>(0.5 * p)});
    all.push_back({q, Vec<3>(0.5 * p), Vec<3>(0.5 * q)});  // either way round
  }
  return all;
}

TEST(FlatOutlines, OfABodyAndItsHole) {
  const auto outlines = flat_outlines(frame());
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_EQ(outlines[0].size(), 4u);
  double reach = 0, inner = 0;
  for (const Vec<2>& X : outlines[0]) reach = std::max(reach, X.norm());
  for (const Vec<2>& X : outlines[1]) inner = std::max(inner, X.norm());
  EXPECT_EQ(reach, std::sqrt(2.0));
  EXPECT_EQ(inner, std::sqrt(0.5));
}

TEST(FlatOutlines, WhatHasNoneIsRefusedWithItsPlace) {
  const auto refused = [](const Triangles& triangles) {
    try {
      flat_outlines(triangles);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Triangles high = frame();
  high[0][0][2] = 0.5;
  EXPECT_NE(refused(high).find("from z = 0 to z = 0.5"), std::string::npos);
  Triangles twice = frame();
  twice.push_back(twice.front());
  EXPECT_NE(refused(twice).find("lie on each other at the edge from"), std::string::npos);
  Triangles far = frame();
  far.push_back({Vec<3>(5, 5, 0), Vec<3>(6, 5, 0), Vec<3>(5, 6, 0)});
  EXPECT_NE(refused(far).find("several bodies: one with a corner at (-1, -1), another with one at (5, 5)"),
            std::string::npos)
      << refused(far);
  Triangles touching = frame();
  touching.push_back({Vec<3>(1, 1, 0), Vec<3>(2, 1, 0), Vec<3>(1, 2, 0)});
  EXPECT_NE(refused(touching).find("touches itself at (1, 1)"), std::string::npos) << refused(touching);
  Triangles over = frame();
  over.push_back({Vec<3>(0.5, 0, 0), Vec<3>(3, -0.1, 0), Vec<3>(3, 0.1, 0)});
  EXPECT_NE(refused(over), "");
  EXPECT_NE(refused({{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(2, 0, 0)}}).find("cover nothing"),
            std::string::npos);
}

}  // namespace
}  // namespace plumb
