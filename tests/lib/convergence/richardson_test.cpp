#include "lib/convergence/richardson.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lib/core/error.hpp"

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
    ASSERT_EQ(result.gci.size(), 2u);
    const double fine = 1.25 * 0.7 * std::pow(0.13, order), next = 1.25 * 0.7 * std::pow(0.2, order);
    EXPECT_NEAR(result.gci[0].absolute, fine, 1e-10);  // Fs times the true error
    EXPECT_NEAR(result.gci[1].absolute, next, 1e-10);
    EXPECT_NEAR(result.gci[0].relative.value(), fine / quantity(0.13, order), 1e-10);
    EXPECT_NEAR(result.gci[1].relative.value(), next / quantity(0.2, order), 1e-10);
    EXPECT_FALSE(result.asymptotic_ratio.has_value());  // it would be 1 by construction
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
  EXPECT_NEAR(100 * result.gci.at(0).relative.value(), 0.103083, 1e-6);
  EXPECT_NEAR(100 * result.gci.at(1).relative.value(), 0.356249, 1e-6);
  EXPECT_NEAR(result.gci.at(0).absolute, 0.00103083 * 0.97050, 1e-8);
}

// Celik et al., J. Fluids Eng. 130, 078001 (2008), Table 1, the two monotone columns; grids of N cells in 2D
// have h = N^(-1/2). Printed: order 1.53, limit 6.1685, index 2.2 %; 0.75, 10.8801, 1.1 %.
TEST(Richardson, TableOfCelikAndOthers) {
  const auto on = [](std::array<double, 3> cells, std::array<double, 3> values) {
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < 3; ++k) samples.push_back({1 / std::sqrt(cells[k]), values[k]});
    return richardson(samples);
  };
  const Extrapolation first = on({18000, 8000, 4500}, {6.063, 5.972, 5.863});
  EXPECT_NEAR(first.order, 1.53, 0.005);
  EXPECT_NEAR(first.limit, 6.1685, 5e-5);
  EXPECT_NEAR(100 * first.gci.at(0).relative.value(), 2.2, 0.05);
  const Extrapolation second = on({18000, 4500, 980}, {10.7880, 10.7250, 10.6050});
  EXPECT_NEAR(second.order, 0.75, 0.005);
  EXPECT_NEAR(second.limit, 10.8801, 5e-5);
  EXPECT_NEAR(100 * second.gci.at(0).relative.value(), 1.1, 0.05);
}

TEST(Richardson, NoRelativeIndexOfAValueThatIsZero) {
  const Extrapolation found = richardson(std::vector<Sample>{{1, 0.0}, {2, 3.0}, {4, 15.0}});  // h^2 - 1
  EXPECT_NEAR(found.order, 2, 1e-9);
  EXPECT_NEAR(found.limit, -1, 1e-9);
  EXPECT_NEAR(found.gci.at(0).absolute, 1.25, 1e-9);
  EXPECT_FALSE(found.gci.at(0).relative.has_value());
  EXPECT_NEAR(found.gci.at(1).relative.value(), 1.25 * 4 / 3, 1e-9);
}

// 2.5 - 0.7 h: declared order 2 gives the second index (0.7/3) over 4 times the first (0.7/3 / 2): 0.5.
TEST(Richardson, ADeclaredOrderCanFail) {
  std::vector<Sample> samples;
  for (double h : {1.0, 2.0, 4.0}) samples.push_back({h, quantity(h, 1)});
  EXPECT_NEAR(richardson(samples, 1.25, 1.0).asymptotic_ratio.value(), 1, 1e-9);
  EXPECT_NEAR(richardson(samples, 1.25, 2.0).asymptotic_ratio.value(), 0.5, 1e-9);
}

TEST(Richardson, FourthGridTestsTheRange) {
  std::vector<Sample> samples;
  for (double h : {0.1, 0.2, 0.4, 0.8}) samples.push_back({h, h * h + 3 * h * h * h});
  const Extrapolation found = richardson(samples);
  EXPECT_EQ(found.gci.size(), 3u);
  // differences 0.051, 0.288, 1.824 of ratio 2: orders ln(0.288/0.051)/ln 2 and ln(1.824/0.288)/ln 2, so that
  // the two indices are in the ratio (r^p - 1)/(r^q - 1) apart
  const double fine = 0.288 / 0.051, coarse = 1.824 / 0.288;
  EXPECT_NEAR(found.asymptotic_ratio.value(), (fine - 1) / (coarse - 1), 1e-9);
  EXPECT_GT(std::abs(found.asymptotic_ratio.value() - 1), 0.05);
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
