#include "plumbline/convergence/richardson.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

using Behaviour = Extrapolation::Behaviour;

double quantity(double h, double order) {
  return 2.5 - 0.7 * std::pow(h, order);
}

// The samples are exact, so limit and order follow to round-off of the small differences (1e-16 / 1e-3).
TEST(Richardson, FindsOrderAndLimitForAnyRatios) {
  for (double order : {0.5, 1.0, 2.0, 3.3}) {
    const std::vector<Sample> samples{
        {0.5, quantity(0.5, order)}, {0.2, quantity(0.2, order)}, {0.13, quantity(0.13, order)}};
    const Extrapolation result = richardson(samples);
    ASSERT_EQ(result.behaviour, Behaviour::monotone);
    EXPECT_NEAR(result.order, order, 1e-10);
    EXPECT_NEAR(result.limit, 2.5, 1e-11);
    EXPECT_NEAR(result.gci_fine, 1.25 * 0.7 * std::pow(0.13, order), 1e-10);  // Fs times the true error
    EXPECT_NEAR(result.asymptotic_ratio, 1, 1e-9);
  }
}

// Roache's example (Verification and Validation in Computational Science and Engineering, pressure recovery
// on three grids, as tabulated on NASA's NPARC site): f = 0.97050, 0.96854, 0.96178 with ratio 2: p
// = 1.786170, limit 0.97130, GCI 0.103083 % and 0.356249 % of the value.
TEST(Richardson, RoachesPressureRecovery) {
  const std::vector<Sample> samples{{1, 0.97050}, {2, 0.96854}, {4, 0.96178}};
  const Extrapolation result = richardson(samples);
  EXPECT_NEAR(result.order, 1.786170, 1e-6);
  EXPECT_NEAR(result.limit, 0.97130, 5e-6);
  EXPECT_NEAR(100 * result.gci_fine / 0.97050, 0.103083, 1e-6);
  EXPECT_NEAR(100 * result.gci_coarse / 0.96854, 0.356249, 1e-6);
}

TEST(Richardson, FourthGridTestsTheRange) {
  std::vector<Sample> samples;
  for (double h : {0.1, 0.2, 0.4, 0.8}) samples.push_back({h, h * h + 3 * h * h * h});
  EXPECT_GT(std::abs(richardson(samples).asymptotic_ratio - 1), 0.05);
}

TEST(Richardson, NamesWhatCannotBeExtrapolated) {
  EXPECT_EQ(richardson(std::vector<Sample>{{1, 1.0}, {2, 1.1}, {4, 1.0}}).behaviour, Behaviour::oscillatory);
  EXPECT_EQ(richardson(std::vector<Sample>{{1, 1.0}, {2, 2.0}, {4, 2.5}}).behaviour, Behaviour::divergent);
  EXPECT_EQ(richardson(std::vector<Sample>{{1, 1.0}, {2, 1.0}, {4, 1.1}}).behaviour, Behaviour::converged);
  EXPECT_TRUE(std::isnan(richardson(std::vector<Sample>{{1, 1.0}, {2, 2.0}, {4, 2.5}}).limit));
  EXPECT_THROW(richardson(std::vector<Sample>{{1, 1.0}, {2, 2.0}}), InputError);
  EXPECT_THROW(richardson(std::vector<Sample>{{1, 1.0}, {1.01, 2.0}, {2, 3.0}}), InputError);
}

TEST(FinestReference, IsRefusedUnlessMuchFiner) {
  const std::vector<Sample> samples{{0.4, 1.4}, {0.2, 1.2}, {0.1, 1.1}};
  EXPECT_THROW(errors_against(samples, {0.1, 1.1}, 1), InputError);
  EXPECT_THROW(errors_against(samples, {0.05, 1.05}, 1), InputError);
  const std::vector<Level> levels = errors_against(samples, {0.01, 1.01}, 1);
  EXPECT_NEAR(levels[2].error, 0.09, 1e-15);
  EXPECT_NEAR(fit_order(levels).order, 1,
              0.1);  // bias of a share of 0.1: (0.39, 0.19, 0.09): pairwise 1.04 and 1.08
}

TEST(FinestReference, ShowsTooHighAnOrderAndIsCorrected) {
  const double seen =
      pairwise_order({2, 4.0 - 1.0}, {1, 2.0 - 1.0});  // first order, values 4, 2, 1 on h = 4, 2, 1
  EXPECT_NEAR(seen, 1.5849625007211562, 1e-14);
  EXPECT_NEAR(order_from_finest(seen, 2), 1, 1e-14);
  for (double order : {0.3, 1.0, 2.0, 3.0})
    for (double ratio : {1.5, 2.0, 3.0})
      EXPECT_NEAR(order_from_finest(order_seen_against_finest(order, ratio), ratio), order, 1e-12);
  EXPECT_THROW(order_from_finest(0.9, 2), InputError);
}

}  // namespace
}  // namespace plumb
