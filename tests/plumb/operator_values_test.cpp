// Every number of `plumb operators` is that of the study made here, and orders are those of the printed
// levels.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/scene/study.hpp"
#include "mms/manufactured.hpp"
#include "mms/operators.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;

const std::string file = PLUMBLINE_SOURCE_DIR "/verification/studies/operators.toml";
const std::string spacings = "study.spacings=[0.1,0.0625,0.05]";

class OperatorValues : public testing::Test {
 protected:
  static json result() {
    const auto outcome = test::run_plumb("operators " + file + " --json - --set " + spacings);
    EXPECT_LE(outcome.code, 1) << outcome.error;
    return json::parse(outcome.out);
  }
};

TEST_F(OperatorValues, AreThoseOfTheLevels) {
  std::vector<std::string> names;
  for (const auto& entry : mms::solution_list()) names.push_back(entry.name);
  const mms::OperatorResult made = mms::run_operators(read_study(file, {spacings}, names));
  const json levels = result()["levels"];
  ASSERT_EQ(levels.size(), made.levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const json& level = levels[k];
    const mms::OperatorLevel& own = made.levels[k];
    EXPECT_EQ(level["n"], own.n);
    EXPECT_EQ(level["d"], own.spacing);
    EXPECT_EQ(level["f_inside"], own.error[0][0]);
    EXPECT_EQ(level["f_boundary"], own.error[0][1]);
    EXPECT_EQ(level["div_p_inside"], own.error[1][0]);
    EXPECT_EQ(level["div_p_boundary"], own.error[1][1]);
    EXPECT_EQ(level["laplacian_inside"], own.error[2][0]);
    EXPECT_EQ(level["laplacian_boundary"], own.error[2][1]);
    EXPECT_EQ(level["constraint_inside"], own.constraint);
  }
}

TEST_F(OperatorValues, PairwiseOrdersAreThoseOfTheLevels) {
  const json all = result();
  const json& levels = all["levels"];
  ASSERT_EQ(all["fits"].size(), 7u);
  for (const json& fit : all["fits"]) {
    std::string key = fit["operator"].get<std::string>() + "_" + fit["part"].get<std::string>();
    for (char& c : key) c = c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    ASSERT_EQ(fit["pairwise"].size(), 2u) << key;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!fit["pairwise"][k].is_number()) {  // an exact zero has no order
        EXPECT_EQ(levels[k][key].get<double>() * levels[k + 1][key].get<double>(), 0) << key;
        continue;
      }
      const double order = std::log(levels[k][key].get<double>() / levels[k + 1][key].get<double>()) /
                           std::log(levels[k]["d"].get<double>() / levels[k + 1]["d"].get<double>());
      EXPECT_NEAR(fit["pairwise"][k].get<double>(), order, 1e-9) << key;
    }
    if (fit["order"].is_number()) {
      EXPECT_EQ(fit["levels"], 3) << key;
    }
  }
}

/// Orders of a static study by the printed levels, those of its vibration among them where each level has
/// one.
TEST(StaticValues, PairwiseOrdersAreThoseOfTheLevels) {
  const auto outcome = test::run_plumb(
      "static " PLUMBLINE_SOURCE_DIR
      "/verification/studies/static_plate.toml --json - --set study.spacings=[0.25,0.2,0.125]");
  ASSERT_LE(outcome.code, 1) << outcome.error;
  const json all = json::parse(outcome.out), levels = all["levels"];
  std::vector<std::string> fitted;
  for (const json& fit : all["fits"]) {
    const std::string norm = fit["norm"], key = norm == "frequency" ? "frequency_error" : "relative_" + norm;
    fitted.push_back(norm);
    ASSERT_EQ(fit["pairwise"].size(), 2u) << key;
    for (std::size_t k = 0; k < 2; ++k) {
      const double order =
          std::log(std::abs(levels[k][key].get<double>() / levels[k + 1][key].get<double>())) /
          std::log(levels[k]["d"].get<double>() / levels[k + 1]["d"].get<double>());
      EXPECT_NEAR(fit["pairwise"][k].get<double>(), order, 1e-9) << key;
    }
  }
  EXPECT_EQ(fitted, (std::vector<std::string>{"l2", "h1", "linf", "stress_l2", "frequency"}));
}

}  // namespace
}  // namespace plumb
