// Where the axes of a picture end, by hand: the data and a little room, ends that are given, one point, none.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/plot/prepare.hpp"

namespace {

using namespace plumb::reports;
using plot::Range;

Range x_of(const std::vector<double>& x, Scale scale, std::optional<double> min = {},
           std::optional<double> max = {}) {
  Picture p{"Ranges", {"x", "", scale, min, max}, {"y"}};
  p.series = {{"one", x, std::vector<double>(x.size(), 1.0)}};
  return plot::prepare(p).x;
}
Range y_of(const std::vector<double>& y, Scale scale, std::optional<double> min = {},
           std::optional<double> max = {}) {
  Picture p{"Ranges", {"x"}, {"y", "", scale, min, max}};
  p.series = {{"one", std::vector<double>(y.size(), 1.0), y}};
  return plot::prepare(p).y;
}

void expect_ends(const Range& range, double low, double high) {
  EXPECT_NEAR(range.low, low, 1e-12 * std::abs(low) + 1e-14);
  EXPECT_NEAR(range.high, high, 1e-12 * std::abs(high) + 1e-14);
}

/// 3 % of the length on each side along x, 6 % along y; of the logarithm on such an axis.
TEST(Ranges, HoldTheDataWithALittleRoom) {
  expect_ends(x_of({2, 7, 12}, Scale::linear), 2 - 0.3, 12 + 0.3);
  expect_ends(y_of({-1, 4}, Scale::linear), -1 - 0.3, 4 + 0.3);
  expect_ends(x_of({1e-3, 1e1}, Scale::log), std::pow(10, -3 - 0.12), std::pow(10, 1 + 0.12));
  expect_ends(y_of({1e-3, 1e-1}, Scale::log), std::pow(10, -3 - 0.12), std::pow(10, -1 + 0.12));
}

TEST(Ranges, OfOnePlaceAreHalfAsMuchOnEachSideOrAFactorOfTwo) {
  expect_ends(x_of({8, 8}, Scale::linear), 4 - 0.03 * 8, 12 + 0.03 * 8);
  expect_ends(x_of({-8}, Scale::linear), -12 - 0.03 * 8, -4 + 0.03 * 8);
  expect_ends(x_of({0}, Scale::linear), -1 - 0.06, 1 + 0.06);
  expect_ends(y_of({8}, Scale::log), 4 * std::pow(4, -0.06), 16 * std::pow(4, 0.06));
}

TEST(Ranges, EndsThatAreGivenStay) {
  expect_ends(x_of({2, 12}, Scale::linear, 0.0), 0, 12.3);
  expect_ends(x_of({2, 12}, Scale::linear, {}, 20.0), 1.7, 20);
  expect_ends(y_of({1e-3, 1e-1}, Scale::log, 1e-5, 1.0), 1e-5, 1);
}

/// Fractions are places on the paper.
TEST(Ranges, FractionsAndValuesAreInverse) {
  const Range linear{2, 12, false}, log{1e-3, 1e1, true};
  EXPECT_DOUBLE_EQ(linear.fraction(4.5), 0.25);
  EXPECT_DOUBLE_EQ(linear.value(0.25), 4.5);
  EXPECT_NEAR(log.fraction(1e-2), 0.25, 1e-14);
  EXPECT_NEAR(log.value(0.75), 1, 1e-13);
}

/// Cells end halfway between their grid points, and as far beyond the outer ones.
TEST(Ranges, OfCells) {
  EXPECT_EQ(plot::cell_borders({1, 2, 4}, false), (std::vector<double>{0.5, 1.5, 3, 5}));
  const auto log = plot::cell_borders({1, 10, 1000}, true);
  ASSERT_EQ(log.size(), 4u);
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_NEAR(std::log10(log[n]), (std::vector{-0.5, 0.5, 2.0, 4.0})[n], 1e-14);
}

}  // namespace
