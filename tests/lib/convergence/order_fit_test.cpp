#include "lib/convergence/order_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

std::vector<Level> power_law(double constant, double order, double ratio, int count) {
  std::vector<Level> levels;
  for (int k = 0; k < count; ++k) {
    const double spacing = 0.2 / std::pow(ratio, k);
    levels.push_back({spacing, constant * std::pow(spacing, order)});
  }
  return levels;
}

// Exact data: the only error is round-off of log and pow, some 1e-15 of the logarithms.
TEST(OrderFit, ExactPowerLawsOfAnyOrderAndRatio) {
  for (double order : {-3.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0})
    for (double ratio : {1.1, 1.5, 2.0, 3.7}) {
      const OrderFit fit = fit_order(power_law(7.0, order, ratio, 5), FitOptions{.round_off = 0});
      EXPECT_NEAR(fit.order, order, 1e-12);
      EXPECT_NEAR(fit.lower, order, 1e-11);
      EXPECT_NEAR(fit.upper, order, 1e-11);
      EXPECT_NEAR(std::exp(fit.log_constant), 7.0, 1e-10);
      EXPECT_NEAR(fit.drift, 0, 1e-11);
      ASSERT_EQ(fit.pairwise.size(), 4u);
      for (double p : fit.pairwise) EXPECT_NEAR(p, order, 1e-12);
    }
}

TEST(OrderFit, GrowingErrorsHaveNegativeOrders) {
  const std::vector<Level> levels{{0.4, 1e-3}, {0.2, 2e-3}, {0.1, 4e-3}, {0.05, 8e-3}};
  const OrderFit fit = fit_order(levels);
  EXPECT_NEAR(fit.order, -1, 1e-13);
  for (double p : fit.pairwise) EXPECT_NEAR(p, -1, 1e-13);
}

TEST(OrderFit, OrderOfTheLevelsDoesNotMatter) {
  const std::vector<Level> coarse_first{{0.4, 3.1}, {0.3, 1.7}, {0.1, 0.2}, {0.05, 0.06}};
  const std::vector<Level> mixed{{0.1, 0.2}, {0.4, 3.1}, {0.05, 0.06}, {0.3, 1.7}};
  EXPECT_DOUBLE_EQ(fit_order(coarse_first).order, fit_order(mixed).order);
  EXPECT_DOUBLE_EQ(fit_order(coarse_first).upper, fit_order(mixed).upper);
  EXPECT_EQ(fit_order(mixed).levels.front(), 0.4);
}

// By hand: ln h = -k ln 2 (k = 0..3), ln e = (0, -2, -4.3, -6) ln 2. Slope 6.1*... see below, all in units of
// ln 2.
TEST(OrderFit, AgreesWithASumDoneByHand) {
  const double l = std::log(2.0);
  const std::vector<double> y{0, -2, -4.3, -6};
  std::vector<Level> levels(4);
  for (int k = 0; k < 4; ++k)
    levels[static_cast<std::size_t>(k)] = {std::exp(-k * l), std::exp(y[static_cast<std::size_t>(k)] * l)};
  // slope = sum (x - xm)(y - ym) / sum (x - xm)^2 with x = -k, xm = -1.5: (1.5*0 - 0.5*2 + 0.5*4.3 + 1.5*6)/5
  // = 2.03 residuals from ym = -3.075: 0.03, 0.06, -0.21, 0.12 -> chi2 = 0.063; s = sqrt(0.063/2/5) =
  // 0.0793725 t(0.975, 2) = 4.302653, so the half-width is 0.341512
  const OrderFit fit = fit_order(levels);
  EXPECT_NEAR(fit.order, 2.03, 1e-12);
  EXPECT_NEAR(fit.half_width(), 4.302652729911275 * std::sqrt(0.0063), 1e-9);
  // quadratic part: the orthogonal pattern (1, -1, -1, 1)/4 of y gives (0 + 2 + 4.3 - 6)/4 = 0.075 per x^2;
  // the slope changes by 2 c2 (x_last - x_first) = 2 * 0.075 * (-3)
  EXPECT_NEAR(fit.drift, -0.45, 1e-12);
}

TEST(OrderFit, WeightsSelectTheLevelsThatCount) {
  const std::vector<Level> levels{{0.4, 1.0}, {0.2, 0.1}, {0.1, 0.025}, {0.05, 0.00625}, {0.025, 0.0015625}};
  const std::vector<double> weights{1e-9, 1, 1, 1, 1};  // the first level is off the line of order 2
  EXPECT_NEAR(fit_order(levels, weights).order, 2, 1e-7);
  EXPECT_GT(fit_order(levels).order, 2.1);
  const std::vector<double> doubled{2e-9, 2, 2, 2, 2};  // weights are relative
  EXPECT_NEAR(fit_order(levels, weights).half_width(), fit_order(levels, doubled).half_width(), 1e-15);
}

// The interval is exact for normal scatter of the logarithms: coverage is binomial with standard deviation
// sqrt(.95*.05/10000) = 0.22 %, so 93-97 % is nine standard deviations wide.
void expect_coverage(int count, bool weighted) {
  std::mt19937_64 random(20240611);
  std::normal_distribution<double> normal;
  int covered = 0;
  for (int draw = 0; draw < 10000; ++draw) {
    std::vector<Level> levels = power_law(3.0, 1.5, 2.0, count);
    std::vector<double> weights;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const double deviation = weighted ? 0.3 / static_cast<double>(k + 1) : 0.1;
      levels[k].error *= std::exp(deviation * normal(random));
      weights.push_back(1 / (deviation * deviation));
    }
    const OrderFit fit = weighted ? fit_order(levels, weights) : fit_order(levels);
    if (fit.lower <= 1.5 && 1.5 <= fit.upper) ++covered;
  }
  EXPECT_GT(covered, 9300);
  EXPECT_LT(covered, 9700);
}

TEST(OrderFit, IntervalCovers95PercentOfDrawsWith4Levels) {
  expect_coverage(4, false);
}
TEST(OrderFit, IntervalCovers95PercentOfDrawsWith7Levels) {
  expect_coverage(7, false);
}
TEST(OrderFit, IntervalCovers95PercentOfDrawsWithWeights) {
  expect_coverage(5, true);
}

TEST(OrderFit, DriftSeesTheSecondTermOfTheExpansion) {
  std::vector<Level> levels;
  for (double h : {0.2, 0.1, 0.05, 0.025}) levels.push_back({h, h * h + 10 * h * h * h});
  const OrderFit fit = fit_order(levels);
  EXPECT_LT(fit.drift, -0.3);  // local slope 2 + 10h/(1+10h): 2.667 on the coarsest, 2.2 on the finest level
  EXPECT_GT(fit.drift, -0.6);
  EXPECT_GT(fit.order, 2.2);
}

TEST(OrderFit, LevelsAtRoundOffAndFinerOnesAreLeftOut) {
  const std::vector<Level> levels{{0.4, 1e-9}, {0.2, 1e-11}, {0.1, 2e-15}, {0.05, 3e-13}};
  const OrderFit fit = fit_order(levels);  // 3e-13 is above the floor, but behind a level that is not
  EXPECT_EQ(fit.levels.size(), 2u);
  EXPECT_EQ(fit.at_round_off, 2u);
  EXPECT_TRUE(std::isnan(fit.upper));  // two points: an order, no interval
  EXPECT_NEAR(fit.order, std::log2(100.0), 1e-12);
}

TEST(OrderFit, LevelsAtTheModellingFloorAreLeftOut) {
  std::vector<Level> levels;
  for (double h : {0.8, 0.4, 0.2, 0.1, 0.05, 0.025}) levels.push_back({h, h * h + 7e-4});
  const OrderFit fit = fit_order(levels, FitOptions{.modelling_floor = 7e-4});
  EXPECT_EQ(fit.at_model_floor, 2u);  // 3.2e-3 and 1.3e-3 are below ten floors; 1.07e-2 is above
  EXPECT_EQ(fit.levels.size(), 4u);
  EXPECT_NEAR(fit.order, 2, 0.05);  // the bias that the factor 10 promises
  EXPECT_LT(fit_order(levels).order, 1.9);
}

TEST(OrderFit, FloorPerLevel) {
  const std::vector<Level> levels{{0.4, 1e-2, 1e-9}, {0.2, 1e-4, 1e-7}, {0.1, 1e-6, 1e-6}};
  EXPECT_EQ(fit_order(levels).at_round_off, 1u);
}

TEST(OrderFit, ZeroErrorsAreRoundOff) {
  const OrderFit fit = fit_order(std::vector<Level>{{0.2, 0}, {0.1, 0}, {0.05, 0}, {0.025, 0}});
  EXPECT_TRUE(fit.levels.empty());
  EXPECT_EQ(fit.at_round_off, 4u);
  EXPECT_TRUE(std::isnan(fit.order));
}

TEST(OrderFit, BrokenRunsAreCountedNotFitted) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const OrderFit fit = fit_order(std::vector<Level>{{0.4, 4}, {0.2, 2}, {0.1, nan}, {0.05, inf}});
  EXPECT_EQ(fit.not_finite, 2u);
  EXPECT_NEAR(fit.order, 1, 1e-13);
}

TEST(OrderFit, SignedErrors) {
  const OrderFit falling = fit_order(std::vector<Level>{{0.4, -4}, {0.2, -1}, {0.1, -0.25}});
  EXPECT_NEAR(falling.order, 2, 1e-13);
  EXPECT_FALSE(falling.sign_changes);
  const OrderFit crossing = fit_order(std::vector<Level>{{0.4, 4}, {0.2, 1}, {0.1, -0.25}});
  EXPECT_TRUE(crossing.sign_changes);
  EXPECT_TRUE(std::isnan(crossing.pairwise[1]));
}

TEST(OrderFit, RefusesWhatHasNoSlope) {
  EXPECT_THROW(fit_order(std::vector<Level>{{0, 1}, {0.1, 1}}), InputError);
  EXPECT_THROW(fit_order(std::vector<Level>{{-0.2, 1}, {0.1, 1}}), InputError);
  EXPECT_THROW(fit_order(std::vector<Level>{{0.1, 1}, {0.1, 2}}), InputError);
  EXPECT_THROW(fit_order(std::vector<Level>{{0.2, 1}, {0.1, 1}}, std::vector<double>{1.0}), InputError);
  EXPECT_THROW(fit_order(std::vector<Level>{{0.2, 1}, {0.1, 1}}, std::vector<double>{1.0, -1.0}), InputError);
}

TEST(OrderFit, OfNothingIsNotDetermined) {
  EXPECT_TRUE(std::isnan(fit_order(std::vector<Level>{}).order));
  EXPECT_TRUE(std::isnan(fit_order(std::vector<Level>{{0.1, 1}}).order));
}

}  // namespace
}  // namespace plumb
