// `plumb material`: one point along a path, as its users see it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

const std::string folder = PLUMBLINE_SOURCE_DIR "/verification/material/";

nlohmann::json json_of(const std::string& arguments) {
  const auto outcome = test::run_plumb("material " + arguments + " --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return nlohmann::json::parse(outcome.out);
}

TEST(MaterialCommand, PlasticCheckValues) {
  const auto json = json_of(folder + "copper-shear.toml");
  ASSERT_EQ(json["rows"].size(), 3u);
  const auto& sheared = json["rows"][1];
  EXPECT_NEAR(sheared["plastic_strain"].get<double>(), 0.0545920806956853, 1e-14);
  EXPECT_NEAR(sheared["q"].get<double>(), 405459208.069568, 1e-4);
  // P_11 and P_21 of the check values, sigma = P F^T with J = 1: sigma_11 = P_11 + P_12 F_12
  EXPECT_NEAR(sheared["cauchy"][0][0].get<double>(), -11689995.772914 + 0.1 * 233799915.458275, 1e-4);
  EXPECT_NEAR(sheared["cauchy"][1][0].get<double>(), 233799915.458275, 1e-4);
  EXPECT_EQ(sheared["iterations"], 1);
  EXPECT_TRUE(sheared["temperature"].is_null());
  EXPECT_TRUE(sheared["damage"].is_null());
  EXPECT_NEAR(json["rows"][2]["plastic_strain"].get<double>(), 0.147010167531522, 1e-14);
}

TEST(MaterialCommand, StepsOfTheCommandLineReplaceThoseOfThePieces) {
  const auto json = json_of(folder + "copper-shear.toml --steps 5");
  ASSERT_EQ(json["rows"].size(), 11u);
  EXPECT_DOUBLE_EQ(json["rows"][5]["t"], 1);
  EXPECT_DOUBLE_EQ(json["rows"][10]["t"], 2);
}

TEST(MaterialCommand, ALawWithoutHistorySaysNull) {
  const auto json = json_of(folder + "sheet.toml");
  const auto& last = json["rows"].back();
  for (const char* key : {"plastic_strain", "temperature", "damage", "iterations"})
    EXPECT_TRUE(last[key].is_null()) << key;
  EXPECT_LT(last["F"][2][2], 1);
  EXPECT_NEAR(last["cauchy"][2][2].get<double>(), 0, 1e-8);  // kappa = 17 MPa, one unit in the last place
  EXPECT_EQ(json["plane"], "stress");
}

TEST(MaterialCommand, EveryFileOfTheFolderRunsAndMakesATable) {
  for (const char* name : {"copper-shear", "copper-cycle", "sheet", "rubber-shear"}) {
    const auto outcome = test::run_plumb("material " + folder + name + ".toml --csv -");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.out.rfind("t,F_11,F_12", 0), 0u) << outcome.out.substr(0, 60);
  }
}

TEST(MaterialCommand, ForwardsAndBackTheYieldStressGoesOnRising) {
  const auto json = json_of(folder + "copper-cycle.toml");
  double before = 0;
  bool elastic_on_the_way_back = false;
  for (const auto& row : json["rows"]) {
    EXPECT_GE(row["plastic_strain"].get<double>(), before);
    elastic_on_the_way_back = elastic_on_the_way_back || (before > 0.03 && row["iterations"] == 0);
    before = row["plastic_strain"];
  }
  EXPECT_TRUE(elastic_on_the_way_back);
  EXPECT_GT(before, 0.15);  // shears of 0.1 + 0.2, over sqrt 3, less the elastic parts
}

TEST(MaterialCommand, ASceneIsNotAPath) {
  const auto outcome =
      test::run_plumb("material " PLUMBLINE_SOURCE_DIR "/verification/scenes/swinging-plate.toml");
  EXPECT_EQ(outcome.code, 2);
}

}  // namespace
}  // namespace plumb
