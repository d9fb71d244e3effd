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
