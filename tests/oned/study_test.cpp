#include "oned/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/core/error.hpp"
#include "oned/account.hpp"
#include "oned/explorer.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;

TEST(RefinementStudy, PublishedTableOfTheCubicField) {
  // an independent program: RMSE to four digits
  const RefinementStudy study =
      refine({}, {20, 40, 80, 160}, {parse_field("poly:1,0,0,1")}, {{"improved", Correction::W1}});
  const double expected[] = {1.130, 0.4093, 0.1464, 0.05208};
  const double half_unit[] = {5e-4, 5e-5, 5e-5, 5e-6};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(study.rows[k].norms.rmse, expected[k], half_unit[k]);
}

TEST(RefinementStudy, NormsOfAKnownError) {
  Discretisation d;
  d.length = 10;
  d.n = 10;
  d.radius.value = 1.5;  // interior: 3 <= X <= 7, the particles 3.5, 4.5, 5.5, 6.5
  const GradientErrors norms = error_norms(make_cloud(d), d.support(), {5, 0, 0, 1, -3, 0, 0, 0, 0, 1});
  EXPECT_DOUBLE_EQ(norms.rmse, std::sqrt(36.0 / 10));
  EXPECT_EQ(norms.max, 5);
  EXPECT_DOUBLE_EQ(*norms.interior_rmse, std::sqrt(10.0 / 4));
  EXPECT_EQ(*norms.interior_max, 3);
  EXPECT_EQ(*norms.boundary_max, 5);
}

TEST(RefinementStudy, InteriorIncludesItsEndsWhateverTheRounding) {
  Discretisation d;  // node layout: 2R = 6 dx is a particle; 0.3 has no exact spacing
  d.length = 0.3;
  d.layout = Layout::node;
  d.radius.value = 3;
  std::vector<double> error(41, 0.0);
  error[6] = 1;
  error[34] = 2;
  EXPECT_EQ(*error_norms(make_cloud(d), d.support(), error).interior_max, 2);
  EXPECT_EQ(*error_norms(make_cloud(d), d.support(), error).boundary_max, 0);
}

TEST(RefinementStudy, ShortBodyHasNoInterior) {
  const RefinementStudy study = refine({}, {12, 40}, {parse_field("sin:1")}, {{"standard", Correction::W1}});
  EXPECT_FALSE(study.rows[0].norms.interior_rmse.has_value());  // 4R = 16 dx > L
  EXPECT_TRUE(study.rows[1].norms.interior_rmse.has_value());
}

Trend trend_of(const RefinementStudy& study, const std::string& norm) {
  return std::find_if(study.fits.begin(), study.fits.end(), [&](const StudyFit& f) { return f.norm == norm; })
      ->trend;
}

TEST(RefinementStudy, TrendsSayWhatTheErrorsDo) {
  const std::vector<Index> cells = {40, 80, 160, 320, 640};
  const TestField cubic = parse_field("poly:1,0,0,1");
  EXPECT_EQ(trend_of(refine({}, cells, {cubic}, {{"improved", Correction::W1}}), "rmse"), Trend::asymptotic);
  EXPECT_EQ(trend_of(refine({}, cells, {cubic}, {{"bond", Correction::W1}}), "rmse"), Trend::stalled);
  EXPECT_EQ(trend_of(refine({}, cells, {cubic}, {{"standard", Correction::none}}), "rmse"), Trend::divergent);
  EXPECT_EQ(trend_of(refine({}, cells, {parse_field("poly:1,1")}, {{"improved", Correction::W1}}), "rmse"),
            Trend::noise_floor);
  // three levels agree to four digits, and no verdict can be made of them
  EXPECT_EQ(trend_of(refine({}, {20, 40, 80}, {cubic}, {{"improved", Correction::W1}}), "interior_rmse"),
            Trend::too_few_levels);
  EXPECT_EQ(trend_of(refine({}, {40}, {cubic}, {{"improved", Correction::W1}}), "rmse"),
            Trend::too_few_levels);
  EXPECT_EQ(trend_of(refine({}, cells, {parse_field("poly:2")}, {{"improved", Correction::W1}}), "rmse"),
            Trend::noise_floor);
}

TEST(RefinementStudy, RefusesBeforeComputing) {
  const TestField field = parse_field("sin:1");
  EXPECT_THROW(refine({}, {}, {field}, {{}}), InputError);
  EXPECT_THROW(refine({}, {20, 20}, {field}, {{}}), InputError);
  EXPECT_THROW(refine({}, {20, 1}, {field}, {{}}), InputError);
  Discretisation fixed;
  fixed.radius = {0.2, true};
  EXPECT_THROW(refine(fixed, {80, 20}, {field}, {{}}), InputError);  // dx = 0.25 at n = 20
  Discretisation d;
  d.kernel = "cubik";
  EXPECT_THROW(refine(d, {20}, {field}, {{}}), InputError);
}

TEST(Explorer, Figure2ShowsThePropertiesThatThePaperNames) {
  Discretisation d;
  d.length = 2;
  d.n = 200;
  d.radius = {1, true};
  for (const KernelRow& row : explore(d, 1).rows) {  // far from the boundary the three kernels overlap
    EXPECT_NEAR(row.W0, row.W, 1e-6);                // the lattice sum differs from 1 by 1e-8
    EXPECT_NEAR(row.W1, row.W, 1e-6);
  }
  const auto wall = explore(d, 0).rows;  // W1 at x = 0 changes sign and peaks higher than the others
  EXPECT_LT(wall.back().W1, 0);
  EXPECT_GT(wall.front().W1, wall.front().W0);
}

TEST(Account, SentencesOfSection41) {
  std::vector<std::pair<std::string, Holds>> found;
  for (const Remark& s : account()) {
    found.emplace_back(s.where, s.holds);
    EXPECT_FALSE(s.finding.empty() || s.measured.empty()) << s.claim;
    for (const auto& [name, number] : s.measured) EXPECT_TRUE(std::isfinite(number)) << name;
  }
  const std::vector<std::pair<std::string, Holds>> expected = {
      {"2.2, Figure 2", Holds::no},      {"2.2, after (14)", Holds::no},    {"4.1, Figure 4", Holds::yes},
      {"4.1, Figure 4", Holds::yes},     {"4.1, Figure 5", Holds::yes},     {"4.1, Figure 5", Holds::partly},
      {"4.1, Figure 6a", Holds::partly}, {"4.1, Figure 6b", Holds::partly}, {"4.1", Holds::no},
      {"4.1, Figure 6", Holds::partly},  {"4.1, Figure 6", Holds::no},      {"4.1, Figure 6", Holds::partly}};
  EXPECT_EQ(found, expected);
}

/// Cubic kernel of support 1 m at the end of 2 m of 200 cells, summed up here; W0 = W/S with its derivative.
TEST(Account, NumbersOfSection22) {
  constexpr double dx = 0.01, h = 0.5;
  double S = 0, dS = 0;
  std::vector<std::array<double, 3>> all;  // X, W, dW by the point of evaluation
  for (int i = 0; i < 200; ++i) {
    const double X = (i + 0.5) * dx, q = X / h, scale = 2 / (3 * h);
    if (q >= 2) continue;
    const double W = scale * (q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * std::pow(2 - q, 3));
    const double dW = -scale / h * (q < 1 ? -3 * q + 2.25 * q * q : -0.75 * std::pow(2 - q, 2));
    all.push_back({X, W, dW});
    S += dx * W;
    dS += dx * dW;
  }
  double first = 0;
  for (const auto& [X, W, dW] : all) first += dx * X * (dW * S - W * dS) / (S * S);
  const auto sentences = account();
  const auto measured = [&](std::size_t sentence, const std::string& name) {
    for (const auto& [key, number] : sentences.at(sentence).measured)
      if (key == name) return number;
    ADD_FAILURE() << name;
    return 0.0;
  };
  EXPECT_NEAR(measured(0, "sum V W at x = 0"), S, 1e-13);
  EXPECT_NEAR(measured(0, "sum V W0 at x = 0"), 1, 1e-13);
  EXPECT_NEAR(measured(0, "sum V W1 at x = 0"), 1, 1e-13);
  EXPECT_NEAR(measured(1, "sum V grad W0 at x = 0 [1/m]"), 0, 1e-12);
  EXPECT_NEAR(measured(1, "sum V X grad W0 at x = 0"), first, 1e-12);
  EXPECT_NEAR(first, 0.377717, 1e-6);
}

}  // namespace
