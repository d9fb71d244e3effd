#include "reports/swing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reports/results.hpp"

namespace plumb::reports::swing_test {
namespace {

struct Series {
  std::vector<double> time, value;
};

/// Rows of a swing of that frequency [Hz], which becomes larger with time, with a wiggle on it.
Series rows(double frequency, double growth, double wiggle, double end) {
  Series s;
  for (int k = 0; k * 0.005 <= end; ++k) {
    const double t = k * 0.005, phase = 2 * std::numbers::pi * frequency * t;
    s.time.push_back(t);
    s.value.push_back(-3 + (2 + growth * t) * std::cos(phase) + wiggle * std::cos(11 * phase));
  }
  return s;
}

TEST(LastSwing, OfACosineIsItsOwn) {
  const Series s = rows(1.1, 0, 0, 10);
  const Swing swing = last_swing(s.time, s.value);
  // a parabola through three rows that are 0.035 rad apart: errors of 0.035^4
  EXPECT_NEAR(swing.mean, -3, 1e-5);
  EXPECT_NEAR(swing.amplitude, 2, 1e-5);
  EXPECT_NEAR(swing.frequency, 1.1, 1e-5);
}

TEST(LastSwing, IsTheLastAndNotTheFirst) {
  const Series s = rows(1.1, 0.05, 0, 10);
  // the last low point is at 10.5 periods = 9.5454.. s, the top before it at 10 periods
  const Swing swing = last_swing(s.time, s.value);
  EXPECT_NEAR(swing.mean, -3 + 0.05 * (10 - 10.5) / 1.1 / 2, 1e-3);
  EXPECT_NEAR(swing.amplitude, 2 + 0.05 * (10 + 10.5) / 1.1 / 2, 1e-3);
  EXPECT_NEAR(swing.frequency, 1.1, 1e-3);
}

TEST(LastSwing, WigglesAreNoSwings) {
  const Series s = rows(1.1, 0, 0.1, 5);
  EXPECT_NEAR(last_swing(s.time, s.value).frequency, 1.1, 0.02);
}

TEST(LastSwing, NeedsTwoLowPoints) {
  const Series s = rows(1.1, 0, 0, 1.2);
  EXPECT_THROW(last_swing(s.time, s.value), MissingResult);
  EXPECT_THROW(widest_swing(s.time, s.value), MissingResult);
}

TEST(WidestSwing, HasTheExtremesOfTheSeries) {
  const Series s = rows(1.1, -0.05, 0, 10);
  // highest at the start, -3 + 2; lowest half a period later, -3 - (2 - 0.05/2.2), from a row that may be off by 0.02 rad
  const Swing swing = widest_swing(s.time, s.value);
  EXPECT_NEAR(swing.mean, -3 + 0.05 / 2.2 / 2, 3e-4);
  EXPECT_NEAR(swing.amplitude, 2 - 0.05 / 2.2 / 2, 3e-4);
  EXPECT_EQ(swing.frequency, last_swing(s.time, s.value).frequency);
}

}  // namespace
}  // namespace plumb::reports::swing_test
