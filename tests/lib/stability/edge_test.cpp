#include "lib/stability/edge.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

TEST(Edge, IsBracketedToTheTolerance) {
  for (const double edge : {0.1, 0.31, 2.9}) {
    int runs = 0;
    const Edge found = find_edge(0.05, 3, 0.01, [&](double value) {
      ++runs;
      return value < edge;
    });
    EXPECT_LT(found.stable, edge);
    EXPECT_GE(found.unstable, edge);
    EXPECT_LE(found.unstable / found.stable, 1.01);
    EXPECT_EQ(found.runs, runs);
    EXPECT_LE(runs, 2 + 9) << "ln(60)/ln(1.01) = 411 intervals, halved 9 times";
  }
}

TEST(Edge, FromZeroTheDistanceIsHalved) {
  const Edge found = find_edge(0, 0.5, 0.02, [](double value) { return value < 0.2; });
  EXPECT_LT(found.stable, 0.2);
  EXPECT_GE(found.unstable, 0.2);
  EXPECT_LE(found.unstable - found.stable, 0.01);
}

TEST(Edge, TheLowerEndIsTriedOnlyIfTheMiddleIsUnstable) {
  for (const double edge : {0.5, 2.0}) {
    int low = 0, runs = 0;
    const Edge found = find_edge(0.1, 10, 0.01, [&](double value) {
      low += value == 0.1;
      ++runs;
      return value < edge;
    });
    EXPECT_EQ(low, edge < 1 ? 1 : 0);
    EXPECT_EQ(found.runs, runs);
    EXPECT_LT(found.stable, edge);
    EXPECT_GE(found.unstable, edge);
  }
}

TEST(Edge, OutsideOfTheRangeOneSideIsMissing) {
  const Edge never = find_edge(1, 2, 0.1, [](double) { return true; });
  EXPECT_EQ(never.stable, 2);
  EXPECT_TRUE(std::isnan(never.unstable));
  const Edge always = find_edge(1, 2, 0.1, [](double) { return false; });
  EXPECT_TRUE(std::isnan(always.stable));
  EXPECT_EQ(always.unstable, 1);
  EXPECT_EQ(always.runs, 3) << "the upper end, the middle, the lower end";
  const Edge close = find_edge(1, 1.05, 0.1, [](double) { return false; });
  EXPECT_TRUE(std::isnan(close.stable)) << "there is no middle to be tried";
  EXPECT_EQ(close.unstable, 1);
  EXPECT_EQ(find_edge(1, 1.05, 0.1, [](double value) { return value < 1.01; }).stable, 1);
}

}  // namespace
}  // namespace plumb
