// What users of `plumb mms`, `plumb operators` and `plumb extrapolate` get.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/richardson.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::orders_test {
namespace {

using test::run_plumb;

const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";

TEST(Orders, MmsGivesDisplacementVelocityAndStressAbsoluteAndRelative) {
  const auto outcome =
      run_plumb("mms " + studies + "swinging_plate.toml --set study.spacings=[0.5,0.4] --json -");
  ASSERT_EQ(outcome.code, 1) << outcome.error;  // two levels are too few
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
  ASSERT_EQ(outcome.code, 1) << outcome.error;  // two levels are too few
  const auto result = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(result["levels"].size(), 2u);
  for (const char* key : {"f_inside", "f_boundary", "div_p_inside", "div_p_boundary", "laplacian_inside",
                          "laplacian_boundary", "constraint_inside"})
    EXPECT_TRUE(result["levels"][0][key].is_number()) << key;
  EXPECT_EQ(result["fits"].size(), 7u);
}

// The force at the boundary holds the traction (THEORY 11.4): without it the "error" of compatible bonds
// would be 5 at d = 0.1 and grow like 1/d; against Div P - P B/V it is 0.13 and does not grow.
TEST(Orders, OperatorsCompareTheBoundaryWithItsTraction) {
  const auto outcome = run_plumb("operators " + studies +
                                 "operators.toml --set method.gradient=compatible --set "
                                 "compatible.table=projected --set study.spacings=[0.1,0.05] --json -");
  const auto result = nlohmann::json::parse(outcome.out);
  const double coarse = result["levels"][0]["div_p_boundary"], fine = result["levels"][1]["div_p_boundary"];
  EXPECT_NEAR(coarse, 0.13, 0.01);  // measured 0.1297 and 0.1182
  EXPECT_NEAR(fine, 0.118, 0.01);
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
  ASSERT_EQ(result["gci"].size(), 2u);
  EXPECT_NEAR(result["gci_absolute"][0].get<double>(), 1.25 * 0.09 / 3, 1e-9);
  EXPECT_NEAR(result["gci_absolute"][1].get<double>(), 1.25 * 0.36 / 3, 1e-9);
  EXPECT_NEAR(result["gci"][0].get<double>(), 1.25 * 0.09 / 3 / 1.03, 1e-9);
  EXPECT_NEAR(result["gci"][1].get<double>(), 1.25 * 0.36 / 3 / 1.12, 1e-9);
  EXPECT_EQ(result["gci_fine"], result["gci_absolute"][0]);  // as it was named when there were two
  EXPECT_EQ(result["gci_coarse"], result["gci_absolute"][1]);
  EXPECT_TRUE(result["asymptotic_ratio"].is_null());  // it could not fail
  EXPECT_TRUE(result["least_squares"].is_null());     // three grids
  EXPECT_EQ(result["status"], "pass");
}

// The printed table of a book (Roache), to its digits, in the text for people.
TEST(Orders, ExtrapolateNamesBothIndices) {
  const auto outcome = run_plumb("extrapolate --spacings 1,2,4 --values 0.97050,0.96854,0.96178");
  EXPECT_NE(outcome.out.find("relative to the finer value (ASME V&V 20): 0.1031 %, 0.3562 %"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("absolute, in the unit of the values: 0.001, 0.00345"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("asymptotic ratio: none"), std::string::npos) << outcome.out;
}

TEST(Orders, ExtrapolateGivesARatioThatCanFail) {
  const std::string three = "extrapolate --spacings 0.4,0.2,0.1 --values 1.48,1.12,1.03 --json - --order ";
  const auto ratio = [](const std::string& call) {
    return nlohmann::json::parse(run_plumb(call).out)["asymptotic_ratio"].get<double>();
  };
  EXPECT_NEAR(ratio(three + "2"), 1, 1e-9);
  EXPECT_NEAR(ratio(three + "1"), 2, 1e-9);  // differences 0.09 and 0.36: 0.36/(2 * 0.09)
  EXPECT_NEAR(ratio("extrapolate --spacings 0.8,0.4,0.2,0.1 --values 2.92,1.48,1.12,1.03 --json -"), 1, 1e-9);
}

// Numbers of tests/lib/convergence/least_squares_test.cpp.
TEST(Orders, ExtrapolateFitsNoisyValuesOnFourGridsAndMore) {
  const auto outcome =
      run_plumb("extrapolate --spacings 4,3,2,1.5,1 --values 1.118,1.08,1.049,1.032,1.021 --json -");
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_NEAR(result["least_squares"]["order"].get<double>(), 1.37725164, 2e-6);
  EXPECT_NEAR(result["least_squares"]["limit"].get<double>(), 1.0037214111, 1e-7);
  EXPECT_EQ(result["least_squares"]["safety"], 1.25);
  EXPECT_NEAR(result["uncertainty"].get<double>(), 0.0228994832, 2e-7);
  EXPECT_EQ(result["least_squares"]["grids"].size(), 5u);
}

// From cfl = 0.01 on RK3 reaches the floor of round-off: what lies there is marked and not fitted, and the
// order is that of the levels above. Loads at t^n are so small at this amplitude that their order 1 shows
// late.
TEST(Orders, TemporalRefinementMarksTheFloor) {
  const auto outcome =
      run_plumb("mms " + std::string(PLUMBLINE_SOURCE_DIR) +
                "/tests/plumb/temporal_floor.toml --temporal --json - --set method.cfl=0.01");
  ASSERT_LE(outcome.code, 1) << outcome.error;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["units"]["l2"], "m^2");
  EXPECT_TRUE(result["notes"].empty());
  std::size_t at_floor = 0;
  for (const auto& row : result["rows"])
    at_floor += row["integrator"] == "rk3" && row["status"] == "at-floor" ? 1 : 0;
  EXPECT_GT(at_floor, 0u);
  EXPECT_LT(at_floor, 3u);
  for (const auto& fit : result["fits"]) {
    if (fit["integrator"] != "rk3" && fit["integrator"] != "verlet") continue;
    const double order = fit["integrator"] == "rk3" ? 3 : 2;
    EXPECT_EQ(fit["declared"], order);
    EXPECT_NEAR(fit["order"].get<double>(), order, 0.1) << fit["integrator"];
    EXPECT_EQ(fit["verdict"], "pass");
  }
}

// The first step is cfl d/C_p, rounded so that it divides the time.
TEST(Orders, TemporalRefinementStartsFromCfl) {
  const auto first_step = [](const std::string& cfl) {
    const auto outcome =
        run_plumb("mms " + std::string(PLUMBLINE_SOURCE_DIR) +
                  "/tests/plumb/temporal_floor.toml --temporal --json - --set method.cfl=" + cfl);
    return nlohmann::json::parse(outcome.out)["rows"][0]["dt"].get<double>();
  };
  const double coarse = first_step("0.2"), fine = first_step("0.1");
  const double young = 17e6, poisson = 0.3,
               speed = std::sqrt(young * (1 - poisson) / (1 + poisson) / (1 - 2 * poisson) / 1100);
  EXPECT_LE(coarse, 0.2 * 0.25 / speed);
  EXPECT_GT(coarse, 0.15 * 0.25 / speed);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
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
}  // namespace plumb::orders_test
