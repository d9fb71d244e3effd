// What sections of the report say of refinement studies.
#include "reports/studies.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumb::reports {
namespace {

using Json = nlohmann::ordered_json;

/// A study with one norm.
Json study(double order, double low, double high, int levels, const std::string& verdict,
           const Json& declared = 2) {
  Json result{{"levels", Json::array()}};
  for (int k = 0; k < levels; ++k)
    result["levels"].push_back({{"d", 0.1 / (k + 1)}, {"relative_l2", 0.1}, {"l2", 1e-6}, {"h1", 1e-5}});
  result["fits"] = Json::array({{{"norm", "l2"},
                                 {"order", order},
                                 {"ci95", {low, high}},
                                 {"pairwise", {order}},
                                 {"levels", levels},
                                 {"declared", declared},
                                 {"verdict", verdict}}});
  return result;
}

// The paper's scheme on the swinging plate with jitter 0.1 is no pass, and its interval contains 2.
TEST(Studies, AnOrderIsContradictedOnlyByAnIntervalThatExcludesIt) {
  EXPECT_FALSE(exclusion_check("", study(1.87, 1.60, 2.13, 4, "not-asymptotic"), "l2", 2).has_value());
  EXPECT_FALSE(exclusion_check("", study(1.90, 1.48, 2.31, 4, "fail"), "l2", 2).has_value());
  EXPECT_FALSE(exclusion_check("", study(2.40, 2.35, 2.45, 4, "above"), "l2", 2).has_value());
  EXPECT_FALSE(exclusion_check("", study(0.90, 0.85, 0.95, 3, "too-few-levels"), "l2", 2).has_value());
  Json broken = study(0.90, 0.85, 0.95, 4, "fail");
  broken["levels"][3]["status"] = "unstable: inverted";
  EXPECT_FALSE(exclusion_check("", broken, "l2", 2).has_value());
  const auto check = exclusion_check("cube", study(1.03, 0.95, 1.11, 4, "fail"), "l2", 2);
  ASSERT_TRUE(check.has_value());
  EXPECT_EQ(check->verdict, "pass");
  EXPECT_EQ(check->what, "cube");
  EXPECT_NE(check->measured.find("[0.95, 1.11]: order 2 is contradicted"), std::string::npos)
      << check->measured;
}

TEST(Studies, WhatDeclaresNothingIsSeen) {
  EXPECT_TRUE(declares(study(2, 1.9, 2.1, 4, "pass"), "l2"));
  EXPECT_FALSE(declares(study(2, 1.9, 2.1, 4, "asymptotic", nullptr), "l2"));
}

TEST(Studies, AnIntervalThatDoesNotExistIsNotPrinted) {
  Json two = study(2, 0, 0, 2, "too-few-levels");
  two["fits"][0]["ci95"] = {nullptr, nullptr};
  EXPECT_EQ(study_check("", two, "l2").measured, "2.00, no interval (fewer than three levels)");
  EXPECT_EQ(study_check("", two, "l2").verdict, "too-few-levels");
  two["fits"][0]["order"] = nullptr;
  EXPECT_EQ(study_check("", two, "l2").measured, "no order can be fitted");
}

// The geometric means of the levels are x = 1/4 and y = 1/16; orders from 1 to 3 through them.
TEST(Studies, TheIntervalIsABandOfPowersThroughTheMiddle) {
  Series series{"a", {1.0 / 8, 0.5, 0.25, 1.0 / 64}, {1.0 / 64, 0.25, 1.0 / 16, 7}};
  add_interval(series, study(2, 1, 3, 3, "pass"), "l2");
  ASSERT_TRUE(series.band.has_value());
  const double low[] = {1.0 / 128, 1.0 / 8, 1.0 / 16, 7}, high[] = {1.0 / 32, 1.0 / 2, 1.0 / 16, 7};
  for (std::size_t k = 0; k < 4; ++k) {  // the finest level was not fitted
    EXPECT_NEAR(series.band->low[k], low[k], 1e-12 * low[k]) << k;
    EXPECT_NEAR(series.band->high[k], high[k], 1e-12 * high[k]) << k;
  }
  Series wide{"a", {0.5, 0.25, 0.125}, {0.25, 0.0625, 0.015625}};
  add_interval(wide, study(2, 0.9, 3, 3, "pass"), "l2");
  EXPECT_FALSE(wide.band.has_value()) << "wider than 2 says nothing";
}

TEST(Studies, OrdersOutsideOfThePictureAreCutOff) {
  DataTable fits = fits_table("fits", "Fits", {});
  add_fits(fits, "a", "job", study(7, 6, 8, 4, "above"), "figure");
  const Figure figure = orders_figure("orders", "Orders", fits, "l2");
  EXPECT_EQ(figure.picture.x.max, 5.0);
  EXPECT_EQ(figure.picture.x.min, -0.1);
  EXPECT_EQ(figure.picture.height, 130);
  const auto& rows = std::get<Intervals>(figure.picture.map);
  EXPECT_EQ(rows.value, std::vector{7.0});
  EXPECT_EQ(rows.low, std::vector{6.0});
  EXPECT_EQ(rows.high, std::vector{8.0});
  EXPECT_EQ(rows.expected, std::vector{2.0});
}

TEST(Studies, LevelsHaveRelativeErrorsFirstAndUnitsOfIntegrals) {
  DataTable table = levels_table("levels", "Levels", {});
  add_levels(table, "a", "job", study(2, 1.9, 2.1, 4, "pass"));
  std::size_t relative = 0, absolute = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    if (table.columns[k].name == "relative l2") relative = k;
    if (table.columns[k].name == "l2") absolute = k;
  }
  EXPECT_LT(relative, absolute);
  EXPECT_EQ(table.columns[relative].unit, "");
  EXPECT_EQ(table.columns[absolute].unit, "m^(1+d/2)");
  EXPECT_EQ(std::get<double>(table.rows[0][relative]), 0.1);
  EXPECT_EQ(std::get<double>(table.rows[0][absolute]), 1e-6);
}

}  // namespace
}  // namespace plumb::reports
