// Whether segments meet, for all segments between the points of a small grid, against exact arithmetic of
// whole numbers that goes another way: where their lines cross, or how far they overlap on a common line.
#include "lib/geometry/crossing.hpp"

#include <gtest/gtest.h>

#include "lib/geometry/shapes/cuboid.hpp"

namespace plumb {
namespace {

struct Point {
  int x, y;
};

/// a + t (b - a) = c + u (d - c) with 0 <= t, u <= 1, by Cramer's rule.
bool meet(Point a, Point b, Point c, Point d) {
  const int px = b.x - a.x, py = b.y - a.y, qx = d.x - c.x, qy = d.y - c.y, rx = c.x - a.x, ry = c.y - a.y;
  const int det = px * qy - py * qx, t = rx * qy - ry * qx, u = rx * py - ry * px;
  if (det > 0) return 0 <= t && t <= det && 0 <= u && u <= det;
  if (det < 0) return det <= t && t <= 0 && det <= u && u <= 0;
  if (rx * py != ry * px || rx * qy != ry * qx) return false;  // parallel, apart
  const auto [low_x, high_x] = std::minmax(a.x, b.x);
  const auto [low_y, high_y] = std::minmax(a.y, b.y);
  const auto [first_x, last_x] = std::minmax(c.x, d.x);
  const auto [first_y, last_y] = std::minmax(c.y, d.y);
  return first_x <= high_x && last_x >= low_x && first_y <= high_y && last_y >= low_y;
}

TEST(Crossing, SegmentsBetweenThePointsOfAGrid) {
  constexpr int n = 4;
  const auto at = [](int k) { return Point{k % n, k / n}; };
  const auto vec = [](Point p) { return Vec<2>(p.x, p.y); };
  long seen = 0, meeting = 0;
  for (int i = 0; i < n * n; ++i)
    for (int j = 0; j < n * n; ++j)
      for (int k = 0; k < n * n; ++k)
        for (int l = 0; l < n * n; ++l) {
          if (i == j || k == l) continue;  // edges have a length
          const Point a = at(i), b = at(j), c = at(k), d = at(l);
          const bool expected = meet(a, b, c, d);
          ++seen, meeting += expected;
          ASSERT_EQ(segments_meet(vec(a), vec(b), vec(c), vec(d)), expected)
              << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << ", " << c.x << ' ' << c.y << ", " << d.x
              << ' ' << d.y;
        }
  EXPECT_EQ(seen, 240 * 240);
  EXPECT_GT(meeting, 10000);
}

TEST(Crossing, AnEdgeFoldsBackOnlyOnItself) {
  const Vec<2> a(0, 0), b(2, 1);
  EXPECT_TRUE(folds_back(a, b, {1, 0.5}));
  EXPECT_TRUE(folds_back(a, b, {-4, -2}));
  EXPECT_FALSE(folds_back(a, b, {4, 2}));     // straight on
  EXPECT_FALSE(folds_back(a, b, {1, 0.51}));  // a sharp angle
  EXPECT_FALSE(folds_back(a, b, {1, 1}));
  EXPECT_DOUBLE_EQ(orientation(a, b, {1, 2}), 3);  // twice the area of the triangle
  EXPECT_DOUBLE_EQ(orientation(b, a, {1, 2}), -3);
}

TEST(Crossing, DistanceToABox) {
  const Cuboid box(ShapeLengths{{"origin", {1, 2}}, {"size", {4, 2}}});
  EXPECT_DOUBLE_EQ(box.distance<2>({2, 3.75}), -0.25);
  EXPECT_DOUBLE_EQ(box.distance<2>({3, 3}), -1);
  EXPECT_DOUBLE_EQ(box.distance<2>({8, 8}), 5);  // beyond the corner (5, 4) by 3 and 4
  EXPECT_DOUBLE_EQ(box.distance<2>({0.5, 3}), 0.5);
}

}  // namespace
}  // namespace plumb
