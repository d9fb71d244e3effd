// The least-squares procedure of Eca and Hoekstra against closed forms, and against numbers of an independent
// computation (normal equations in Python, the order by 2000 steps and golden sections), to their ten
// decimals.
#include "lib/convergence/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

using Expansion = GridFit::Expansion;

const std::vector<double> spacings{1, 1.5, 2, 3, 4};

std::vector<Sample> samples_of(const std::vector<double>& values) {
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < values.size(); ++k) samples.push_back({spacings[k], values[k]});
  return samples;
}

constexpr double decimals = 2e-8;  // the order is found to 1e-8 or so, and limits follow it

// Without scatter sigma and |value - fit| are round-off, so U is 1.25 times the true error.
TEST(GridFit, AnExactPowerLawGivesItsOrderAndLimit) {
  for (const double order : {0.6, 1.0, 1.5, 1.9}) {
    std::vector<Sample> samples;
    for (const double h : spacings) samples.push_back({0.01 * h, 2.5 - 0.7 * std::pow(h, order)});
    const GridFit fit = fit_grids(samples);
    EXPECT_EQ(fit.expansion, Expansion::power);
    EXPECT_NEAR(fit.order.value(), order, 1e-6);
    EXPECT_NEAR(fit.limit, 2.5, 1e-6);
    EXPECT_LT(fit.deviation, 1e-7);
    EXPECT_EQ(fit.safety, 1.25);
    EXPECT_NEAR(fit.range, 0.7 * (std::pow(4, order) - 1) / 4, 1e-12);
    for (std::size_t k = 0; k < spacings.size(); ++k) {
      EXPECT_NEAR(fit.grids[k].spacing, 0.01 * spacings[k], 1e-15);
      EXPECT_NEAR(fit.grids[k].error, 0.7 * std::pow(spacings[k], order), 1e-6);
      EXPECT_NEAR(fit.grids[k].uncertainty, 1.25 * 0.7 * std::pow(spacings[k], order), 2e-6);
    }
  }
}

TEST(GridFit, TakesTheWeightsOfLeastDeviation) {
  const GridFit plain = fit_grids(samples_of({1.021, 1.032, 1.049, 1.08, 1.118}));
  EXPECT_EQ(plain.expansion, Expansion::power);
  EXPECT_FALSE(plain.weighted);
  EXPECT_NEAR(plain.order.value(), 1.37725164, 2e-6);
  EXPECT_NEAR(plain.limit, 1.0037214111, 1e-7);
  EXPECT_NEAR(plain.deviation, 0.0013918339, decimals);
  EXPECT_NEAR(plain.grids[0].uncertainty, 0.0228994832, 2e-7);
  const GridFit weighted = fit_grids(samples_of({1.021, 1.0345, 1.049, 1.08, 1.11}));
  EXPECT_EQ(weighted.expansion, Expansion::power);
  EXPECT_TRUE(weighted.weighted);
  EXPECT_NEAR(weighted.order.value(), 1.11034471, 2e-6);
  EXPECT_NEAR(weighted.limit, 0.9964031581, 1e-7);
  EXPECT_NEAR(weighted.deviation, 0.0005442790, decimals);
  EXPECT_NEAR(weighted.grids[0].uncertainty, 0.0312560808, 2e-7);
}

// Order 3.05: the better one of h and h^2, and the safety factor 3.
TEST(GridFit, TooHighAnOrderIsNotBelieved) {
  const GridFit fit = fit_grids(samples_of({1.001, 1.0034, 1.008, 1.027, 1.065}));
  EXPECT_NEAR(fit.order.value(), 3.05594808, 2e-6);
  EXPECT_EQ(fit.expansion, Expansion::second);
  EXPECT_TRUE(fit.weighted);
  EXPECT_NEAR(fit.limit, 0.9946442617, decimals);
  EXPECT_NEAR(fit.deviation, 0.0036844947, decimals);
  EXPECT_EQ(fit.safety, 3);
  EXPECT_NEAR(fit.grids[0].error, 0.0041082563, decimals);
  EXPECT_NEAR(fit.grids[0].uncertainty, 0.0182567455, decimals);
}

// No order above 0.01: the best of h, h^2 and both.
TEST(GridFit, TooLowAnOrderIsNotBelieved) {
  const GridFit fit = fit_grids(samples_of({1.10, 1.13, 1.14, 1.155, 1.165}));
  EXPECT_FALSE(fit.order.has_value());
  EXPECT_EQ(fit.expansion, Expansion::first_and_second);
  EXPECT_FALSE(fit.weighted);
  EXPECT_NEAR(fit.limit, 1.0527238806, decimals);
  EXPECT_EQ(fit.safety, 3);
  EXPECT_NEAR(fit.grids[0].uncertainty, 0.1641663554, decimals);
}

// Deviation 0.1759, range 0.1: 3 sigma/range times the sum.
TEST(GridFit, ScatterBeyondTheRangeWidensTheUncertainty) {
  const GridFit fit = fit_grids(samples_of({1.0, 1.2, 0.9, 1.3, 0.95}));
  EXPECT_EQ(fit.expansion, Expansion::first);
  EXPECT_TRUE(fit.weighted);
  EXPECT_NEAR(fit.deviation, 0.1758703298, decimals);
  EXPECT_NEAR(fit.range, 0.1, 1e-12);
  EXPECT_NEAR(fit.grids[0].uncertainty, 1.2713560767, decimals);
}

TEST(GridFit, EqualValuesAreCertain) {
  const GridFit fit = fit_grids(samples_of({2, 2, 2, 2, 2}));
  EXPECT_NEAR(fit.limit, 2, 1e-12);
  EXPECT_EQ(fit.grids[0].uncertainty, 0);
}

TEST(GridFit, RefusesFewerThanFourGridsAndWhatIsNotFinite) {
  EXPECT_THROW(fit_grids(std::vector<Sample>{{1, 1}, {2, 2}, {3, 3}}), InputError);
  EXPECT_THROW(fit_grids(samples_of({1, 2, std::nan(""), 3, 4})), InputError);
}

}  // namespace
}  // namespace plumb
