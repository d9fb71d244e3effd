#include "lib/convergence/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace plumb {
namespace {

std::vector<Level> levels_of(const std::function<double(double)>& error, int count = 5, double ratio = 2) {
  std::vector<Level> levels;
  for (int k = 0; k < count; ++k) {
    const double h = 0.2 / std::pow(ratio, k);
    levels.push_back({h, error(h)});
  }
  return levels;
}

Verdict verdict(const std::function<double(double)>& error, double declared, int count = 5) {
  return judge(fit_order(levels_of(error, count)), declared);
}

Trend trend(const std::function<double(double)>& error, int count = 5) {
  return classify(fit_order(levels_of(error, count)));
}

TEST(Verdict, PassNeedsTheDeclaredOrderFromBothSides) {
  const auto second = [](double h) { return 3 * h * h; };
  EXPECT_EQ(verdict(second, 2), Verdict::pass);
  EXPECT_EQ(verdict(second, 1), Verdict::above);  // better than declared is not a pass
  EXPECT_EQ(verdict(second, 3), Verdict::fail);
  EXPECT_EQ(verdict(second, 1.5), Verdict::above);
  EXPECT_EQ(verdict(second, 2.004), Verdict::pass);  // the same two decimals
  EXPECT_EQ(verdict(second, 2.09), Verdict::fail);   // 2.00 [2.00, 2.00] excludes it
  EXPECT_EQ(verdict(second, 1.91), Verdict::above);
}

TEST(Verdict, PassForAnyRefinementRatio) {
  for (double ratio : {1.2, 1.5, 3.0})
    EXPECT_EQ(judge(fit_order(levels_of([](double h) { return h; }, 4, ratio)), 1), Verdict::pass);
}

// A scheme of order 2 whose next term is 4 %: 2.04, 2.01, 2.003, 2.0007 from pair to pair.
TEST(Verdict, ABiasThatFadesUnderRefinementPasses) {
  for (double sign : {-1.0, 1.0}) {
    const auto fading = [&](double h) { return h * h * (1 + sign * h * h); };
    const OrderFit fit = fit_order(levels_of(fading));
    EXPECT_EQ(judge(fit, 2), Verdict::pass);
    EXPECT_LT(std::abs(fit.order - 2), 0.03);
  }
}

TEST(Verdict, ABiasThatStaysDoesNotPassOnEitherSide) {
  for (double order : {1.96, 1.91, 2.04, 2.09}) {
    const OrderFit fit = fit_order(levels_of([&](double h) { return std::pow(h, order); }));
    EXPECT_LT(std::abs(fit.order - 2), 0.1);  // within the resolution, yet another order
    EXPECT_EQ(judge(fit, 2), order < 2 ? Verdict::fail : Verdict::above) << order;
  }
}

TEST(Verdict, PairsThatLeaveTheDeclaredOrderDoNotPass) {
  const auto from_orders = [](const std::vector<double>& orders) {
    std::vector<Level> levels{{0.4, 1}};
    for (double p : orders)
      levels.push_back({levels.back().spacing / 2, levels.back().error / std::pow(2, p)});
    return levels;
  };
  EXPECT_EQ(judge(fit_order(from_orders({1.84, 1.96, 1.99, 2.00})), 2), Verdict::pass);
  EXPECT_EQ(judge(fit_order(from_orders({2.00, 1.99, 1.96, 1.84})), 2), Verdict::not_asymptotic);
  EXPECT_EQ(judge(fit_order(from_orders({2.00, 2.01, 2.04, 2.16})), 2), Verdict::not_asymptotic);
  // the interval of 1.92 contains 2, but the slope falls from pair to pair and ends at 1.76
  const OrderFit falling = fit_order(from_orders({2.08, 1.97, 1.86, 1.76}));
  EXPECT_LT(2, falling.upper);
  EXPECT_EQ(judge(falling, 2), Verdict::not_asymptotic);
}

// Pairs 2.13, 2.04, 2.09, as of compatible bonds on the swinging plate at finite strain (Gauss points).
TEST(Verdict, AnOrderAboveTheDeclaredOneIsNoFailure) {
  std::vector<Level> levels{{0.4, 1}};
  for (const double order : {2.13, 2.04, 2.09})
    levels.push_back({levels.back().spacing / 2, levels.back().error / std::pow(2, order)});
  const OrderFit fit = fit_order(levels);
  EXPECT_GT(fit.lower, 2.005);
  EXPECT_EQ(judge(fit, 2), Verdict::above);
}

TEST(Verdict, AnOrderIsExcludedByItsIntervalOnly) {
  const auto first = [](double h) { return h; };
  EXPECT_TRUE(excludes(fit_order(levels_of(first)), 2));
  EXPECT_FALSE(excludes(fit_order(levels_of(first)), 1));
  EXPECT_FALSE(excludes(fit_order(levels_of(first, 3)), 2));                            // too few levels
  EXPECT_FALSE(excludes(fit_order(levels_of([](double h) { return h * h * h; })), 2));  // above
  EXPECT_FALSE(excludes(fit_order(levels_of([](double h) { return std::pow(h, 1.95); })), 2));
  EXPECT_TRUE(excludes(fit_order(levels_of([](double h) { return std::pow(h, 1.85); })), 2));
  // 1.87 and an interval that contains 2: no pass, and not excluded either
  const std::vector<Level> wide{{0.2, 1.0}, {0.1, 0.22}, {0.05, 0.078}, {0.025, 0.019}};
  EXPECT_GT(fit_order(wide).upper, 2);
  EXPECT_FALSE(excludes(fit_order(wide), 2));
  std::vector<Level> broken = levels_of(first);
  broken.push_back({1e-4, std::nan("")});
  EXPECT_FALSE(excludes(fit_order(broken), 2));
}

TEST(Verdict, FewerThanFourLevelsAreTooFew) {
  for (int count : {0, 1, 2, 3})
    EXPECT_EQ(verdict([](double h) { return h * h; }, 2, count), Verdict::too_few_levels);
}

TEST(Verdict, ADivergingMethodFails) {
  const auto growing = [](double h) { return 1e-3 / (h * h); };
  EXPECT_EQ(verdict(growing, 2), Verdict::fail);  // abs() of the order would pass it
}

TEST(Verdict, ABrokenRunFails) {
  std::vector<Level> levels = levels_of([](double h) { return h * h; });
  levels.push_back({1e-4, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(judge(fit_order(levels), 2), Verdict::fail);
}

TEST(Verdict, StalledErrorsDoNotPass) {
  EXPECT_EQ(verdict([](double) { return 1e-3; }, 2), Verdict::fail);
  // order 2 that runs into a floor nobody told of: the slope drifts from 2 to 0
  EXPECT_EQ(verdict([](double h) { return h * h + 1e-3; }, 2), Verdict::not_asymptotic);
}

TEST(Verdict, KnownFloorLeavesTooFewLevels) {
  const auto floored = [](double h) { return h * h + 1e-3; };
  EXPECT_EQ(judge(fit_order(levels_of(floored), FitOptions{.modelling_floor = 1e-3}), 2),
            Verdict::noise_floor);
  // with eight levels from a coarser start enough are left
  std::vector<Level> wide;
  for (double h : {3.2, 1.6, 0.8, 0.4, 0.2, 0.1, 0.05}) wide.push_back({h, floored(h)});
  EXPECT_EQ(judge(fit_order(wide, FitOptions{.modelling_floor = 1e-3}), 2), Verdict::pass);
}

TEST(Verdict, RoundOffIsNoiseFloor) {
  EXPECT_EQ(verdict([](double) { return 0.0; }, 2), Verdict::noise_floor);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1e-15);
  EXPECT_EQ(verdict([&](double) { return uniform(random); }, 2), Verdict::noise_floor);
}

TEST(Verdict, ADriftingSlopeIsNotAsymptotic) {
  const auto exponential = [](double h) { return std::exp(-0.3 / h); };  // pairwise orders 2.2, 4.3, 8.7
  EXPECT_EQ(verdict(exponential, 2, 4), Verdict::not_asymptotic);
  // measured 2.5, on the way from 3 to 2: not asymptotic for those who declare 2, wrong for those who declare
  // 3
  const auto mixed = [](double h) { return h * h + 13 * h * h * h; };
  EXPECT_EQ(verdict(mixed, 2, 4), Verdict::not_asymptotic);
  EXPECT_EQ(verdict(mixed, 3, 4), Verdict::fail);
}

TEST(Verdict, ASignChangeIsNotAsymptotic) {
  EXPECT_EQ(verdict([](double h) { return h * h - 0.03 * h; }, 2), Verdict::not_asymptotic);
  EXPECT_EQ(verdict([](double h) { return -h * h; }, 2), Verdict::pass);
}

TEST(Verdict, WildScatterIsInconclusive) {
  const std::vector<Level> levels{{0.2, 1.0}, {0.1, 0.05}, {0.05, 0.12}, {0.025, 0.006}};
  const OrderFit fit = fit_order(levels);
  EXPECT_LT(fit.lower, 2);  // 2 is inside, but so is nearly everything
  EXPECT_GT(fit.upper, 2);
  EXPECT_EQ(judge(fit, 2), Verdict::inconclusive);
}

// 10 % scatter and six levels: the right order must pass most of the time, an order 1/2 off never (the
// widened interval reaches 0.5 at most, and the fitted order scatters by 0.1/sqrt(17.5)/ln 2 = 0.035).
TEST(Verdict, PowerOnNoisyData) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0, 0.1);
  int right = 0, wrong = 0;
  for (int draw = 0; draw < 1000; ++draw) {
    std::vector<Level> levels = levels_of([](double h) { return h * h; }, 6);
    for (Level& level : levels) level.error *= std::exp(normal(random));
    const OrderFit fit = fit_order(levels);
    right += judge(fit, 2) == Verdict::pass;
    wrong += judge(fit, 1.5) == Verdict::pass;
  }
  EXPECT_GT(right, 850);
  EXPECT_EQ(wrong, 0);
}

// An order of 1.9 under 1 % scatter: the fitted order scatters by 0.01/sqrt(10)/ln 2 = 0.005, its interval is
// mostly narrower than 0.1. The wrong order lies in a 95 % interval in far less than 5 % of the draws, the
// right one in 95 %.
TEST(Verdict, AnOrderATenthOffIsSeenInTenThousandDraws) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal(0, 0.01);
  int right = 0, wrong = 0;
  for (int draw = 0; draw < 10000; ++draw) {
    std::vector<Level> levels = levels_of([](double h) { return std::pow(h, 1.9); }, 5);
    for (Level& level : levels) level.error *= std::exp(normal(random));
    const OrderFit fit = fit_order(levels);
    right += judge(fit, 1.9) == Verdict::pass;
    wrong += judge(fit, 2) == Verdict::pass;
  }
  EXPECT_GT(right, 9300);
  EXPECT_LT(wrong, 500);
}

TEST(Trend, SaysWhatTheErrorsDo) {
  EXPECT_EQ(trend([](double h) { return h * std::sqrt(h); }), Trend::asymptotic);
  EXPECT_EQ(trend([](double) { return 0.37; }), Trend::stalled);
  EXPECT_EQ(trend([](double h) { return h * h + 0.1; }), Trend::stalled);
  EXPECT_EQ(trend([](double h) { return 1 / std::sqrt(h); }), Trend::divergent);
  EXPECT_EQ(trend([](double h) { return std::exp(-0.3 / h); }, 4), Trend::not_asymptotic);
  EXPECT_EQ(trend([](double) { return 1e-16; }), Trend::noise_floor);
}

TEST(Trend, ThreeLevelsAreTooFewWhateverTheyDo) {
  for (int count : {0, 1, 2, 3}) {
    EXPECT_EQ(trend([](double h) { return h * h; }, count), Trend::too_few_levels);
    EXPECT_EQ(trend([](double) { return 0.1; }, count), Trend::too_few_levels);
    EXPECT_EQ(trend([](double h) { return 1 / h; }, count), Trend::too_few_levels);
    EXPECT_EQ(trend([](double) { return 0.0; }, count), Trend::too_few_levels);
  }
  // a run that broke is no matter of counting
  EXPECT_EQ(trend([](double) { return std::nan(""); }, 1), Trend::divergent);
}

TEST(Trend, GrowthAfterAFallIsDivergentWhateverTheFitSays) {
  const std::vector<Level> levels{{0.4, 1}, {0.2, 0.1}, {0.1, 0.01}, {0.05, 0.02}, {0.025, 0.08}};
  EXPECT_GT(fit_order(levels).order, 0);
  EXPECT_EQ(classify(fit_order(levels)), Trend::divergent);
}

TEST(Trend, RoundOffGrowthIsNoiseFloorWhenTheFloorIsGiven) {
  std::vector<Level> levels;
  for (double h : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) levels.push_back({h, h * h * h * h + 1e-16 / h, 1e-16 / h});
  EXPECT_EQ(classify(fit_order(levels)), Trend::noise_floor);
}

}  // namespace
}  // namespace plumb
