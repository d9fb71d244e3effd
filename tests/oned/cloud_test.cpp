#include "oned/cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "lib/core/error.hpp"
#include "oned/gradient.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;

TEST(Cloud, CellLayout) {
  const Cloud<1> cloud = make_cloud({});
  ASSERT_EQ(cloud.X.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(cloud.X[i][0], (static_cast<double>(i) + 0.5) / 8);
    EXPECT_EQ(cloud.V[i], 0.125);
  }
}

TEST(Cloud, NodeLayoutHasHalfVolumesAtTheEnds) {
  Discretisation d;
  d.layout = Layout::node;
  const Cloud<1> cloud = make_cloud(d);
  ASSERT_EQ(cloud.X.size(), 41u);
  EXPECT_EQ(cloud.X.front()[0], 0);
  EXPECT_EQ(cloud.X.back()[0], 5);
  EXPECT_EQ(cloud.V.front(), 0.0625);
  EXPECT_EQ(cloud.V[1], 0.125);
  EXPECT_EQ(cloud.V.back(), 0.0625);
}

TEST(Cloud, JitterKeepsOrderEndsAndTotalVolume) {
  for (const Layout layout : {Layout::cell, Layout::node}) {
    Discretisation d;
    d.layout = layout;
    d.jitter = 0.49;
    d.seed = 3;
    const Cloud<1> cloud = make_cloud(d);
    EXPECT_TRUE(std::is_sorted(cloud.X.begin(), cloud.X.end(),
                               [](const Vec<1>& a, const Vec<1>& b) { return a[0] < b[0]; }));
    EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 5, 1e-14);
    if (layout == Layout::node) {
      EXPECT_EQ(cloud.X.front()[0], 0);
      EXPECT_EQ(cloud.X.back()[0], 5);
    }
    // Voronoi cells: half of both gaps
    EXPECT_NEAR(cloud.V[7], (cloud.X[8][0] - cloud.X[6][0]) / 2, 1e-15);
    EXPECT_NEAR(cloud.V[0], (cloud.X[0][0] + cloud.X[1][0]) / 2, 1e-15);
    d.seed = 4;
    EXPECT_NE(make_cloud(d).X[5][0], cloud.X[5][0]);
    d.seed = 3;
    EXPECT_EQ(make_cloud(d).X[5][0], cloud.X[5][0]);
  }
}

TEST(Cloud, WindowsAgreeWithBruteForce) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> position(0, 1);
  for (const double R : {0.11, 0.3, 2.0}) {
    std::vector<double> positions(60);
    for (double& X : positions) X = position(random);
    const Cloud<1> cloud = voronoi_cloud(1, positions);
    const auto all = windows(cloud, R);
    for (std::size_t i = 0; i < cloud.X.size(); ++i) {
      const Window bisected = window_at(cloud, R, cloud.X[i][0]);
      EXPECT_EQ(bisected.first, all[i].first);
      EXPECT_EQ(bisected.last, all[i].last);
      for (Index j = 0; j < 60; ++j)
        EXPECT_EQ(j >= all[i].first && j < all[i].last, std::abs(cloud.X[j][0] - cloud.X[i][0]) < R);
    }
  }
}

TEST(Cloud, NeighboursAtExactlyTheRadiusAreOutsideWhateverTheRounding) {
  for (const double length : {5.0, 0.3, 7e8, 1.0 / 3}) {  // spacings that are not exact
    Discretisation d;
    d.length = length;
    const Cloud<1> cloud = make_cloud(d);
    for (const Window& window : windows(cloud, d.support())) EXPECT_LE(window.count(), 7);
    EXPECT_EQ(windows(cloud, d.support())[20].count(), 7);
  }
}

std::string complaint(const Discretisation& d) {
  try {
    windows(make_cloud(d), d.support());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Cloud, RefusesARadiusThatReachesNobody) {
  Discretisation d;
  d.radius.value = 1;
  const std::string text = complaint(d);
  EXPECT_NE(text.find("particle 0 at X = 0.0625"), std::string::npos) << text;
  EXPECT_NE(text.find("0 neighbours"), std::string::npos) << text;
}

TEST(Cloud, RefusesBadSizes) {
  const auto with = [](auto change) {
    Discretisation d;
    change(d);
    return complaint(d);
  };
  EXPECT_NE(with([](auto& d) { d.length = 0; }).find("length"), std::string::npos);
  EXPECT_NE(with([](auto& d) { d.length = std::numeric_limits<double>::infinity(); }).find("length"),
            std::string::npos);
  EXPECT_NE(with([](auto& d) { d.n = 1; }).find("n is 1"), std::string::npos);
  EXPECT_NE(with([](auto& d) { d.jitter = 0.5; }).find("jitter"), std::string::npos);
  EXPECT_NE(with([](auto& d) { d.jitter = std::nan(""); }).find("jitter"), std::string::npos);
  EXPECT_NE(with([](auto& d) { d.radius = {-1, true}; }).find("radius"), std::string::npos);
}

TEST(Cloud, RefusesCoincidentParticlesWithBothNumbers) {
  try {
    voronoi_cloud(1, {0.1, 0.7, 0.3, 0.7 + 1e-12});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("particles 1 and 3 coincide"), std::string::npos)
        << error.what();
  }
}

TEST(Cloud, WarnsOfARadiusOfOneSpacingAndOfAliasing) {
  Discretisation d;
  d.radius.value = 3.7;
  EXPECT_TRUE(warnings(d, {parse_field("sin:5")}).empty());
  EXPECT_EQ(warnings(d, {parse_field("sin:26")}).size(), 1u);  // k dx = 3.25 > pi
  EXPECT_TRUE(warnings(d, {parse_field("sin:25")}).empty());   // 3.125
  d.radius.value = 4;
  EXPECT_TRUE(warnings(d, {}).empty());  // W(R) = 0: whether those at r = R count changes nothing
  d.radius.value = 1 + 1e-10;
  EXPECT_NE(warnings(d, {}).at(0).find("rounding picks"), std::string::npos);
  d.jitter = 0.1;
  EXPECT_TRUE(warnings(d, {}).empty());
}

TEST(Cloud, OneValuePerParticleIsAsked) {
  const Cloud<1> cloud = make_cloud({});
  EXPECT_THROW(estimate(cloud, kernel_named<1>("cubic"), 0.5, {}, std::vector<double>(39)), InputError);
}

}  // namespace
