// What users of `plumb mms`, `plumb operators` and `plumb extrapolate` get.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "plumbline/convergence/richardson.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;

const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";

TEST(Orders, MmsGivesDisplacementVelocityAndStressAbsoluteAndRelative) {
  const auto outcome =
      run_plumb("mms " + studies + "swinging_plate.toml --set study.spacings=[0.5,0.4] --json -");
  ASSERT_LE(outcome.code, 1) << outcome.error;  // two levels are inconclusive
  const auto result = nlohmann::json::parse(outcome.out);
  for (const char* norm : {"l2", "h1", "linf", "velocity_l2", "stress_l2"})
    for (const std::string& name : {std::string(norm), std::string(norm) + "_gauss"}) {
      for (const auto& level : result["levels"]) {
        EXPECT_GT(level["setup_s"].get<double>(), 0);
        ASSERT_TRUE(level[name].is_number()) << name;
        const double relative = level["relative_" + name].get<double>();
        EXPECT_GT(relative, 0) << name;
        EXPECT_LT(relative, 1) << name;
      }
      bool fitted = false;
      for (const auto& fit : result["fits"]) fitted = fitted || fit["norm"] == name;
      EXPECT_TRUE(fitted) << name;
    }
}

TEST(Orders, OperatorsArePrintedWithBothParts) {
  const auto outcome =
      run_plumb("operators " + studies + "operators.toml --set study.spacings=[0.1,0.05] --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const auto result = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(result["levels"].size(), 2u);
  for (const char* key : {"f_inside", "f_boundary", "div_p_inside", "div_p_boundary", "laplacian_inside",
                          "laplacian_boundary", "constraint_inside"})
    EXPECT_TRUE(result["levels"][0][key].is_number()) << key;
  EXPECT_EQ(result["fits"].size(), 7u);
}

TEST(Orders, OperatorsRefuseABodyWithoutInside) {
  const auto outcome = run_plumb("operators " + studies + "operators.toml --set study.spacings=[0.5,0.25]");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("leaves no inside"), std::string::npos) << outcome.error;
}

// 1 + 3 h^2 on 0.4, 0.2, 0.1: order 2, limit 1, index 1.25 (0.12 - 0.03)/3.
TEST(Orders, ExtrapolateFindsOrderLimitAndIndex) {
  const auto outcome = run_plumb("extrapolate --spacings 0.4,0.2,0.1 --values 1.48,1.12,1.03 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_NEAR(result["order"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(result["limit"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(result["gci_fine"].get<double>(), 1.25 * 0.09 / 3, 1e-9);
}

TEST(Orders, ExtrapolateRefusesTheFinestGridAsReference) {
  const auto outcome =
      run_plumb("extrapolate --spacings 0.4,0.2,0.1 --values 1.48,1.12,1.03 --reference 0.1,1.03");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("1.585"), std::string::npos) << outcome.error;
  EXPECT_EQ(run_plumb("extrapolate --spacings 0.4,0.2 --values 1.48,1.12").code, 2);
  EXPECT_EQ(run_plumb("extrapolate --spacings 0.4,0.2,0.1 --values 1.48,1.12").code, 2);
}

TEST(Orders, ExtrapolateTellsOscillationFromConvergence) {
  EXPECT_EQ(run_plumb("extrapolate --spacings 0.4,0.2,0.1 --values 1,1.2,1.1").code, 1);
}

}  // namespace
}  // namespace plumb
