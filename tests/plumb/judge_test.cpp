// `plumb judge`: tables that other programs made.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_shell;

/// Writes the text to table.csv in a folder of its own and judges it there.
test::Outcome judge(const std::string& text, const std::string& options = "") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "table.csv") << text;
  return run_shell("cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " judge table.csv " + options);
}

nlohmann::json result_of(const std::string& text, const std::string& options = "") {
  return nlohmann::json::parse(judge(text, options + " --json -").out);
}

const std::string plain = "h,l2,h1\n0.4,0.32,4\n0.2,0.08,2\n0.1,0.02,1\n0.05,0.005,0.5\n";  // 2 h^2 and 10 h

TEST(Judge, OrdersOfAllColumnsOrOfThoseNamed) {
  const auto all = result_of(plain);
  ASSERT_EQ(all["fits"].size(), 2u);
  EXPECT_EQ(all["fits"][0]["norm"], "l2");
  EXPECT_NEAR(all["fits"][0]["order"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(all["fits"][1]["order"].get<double>(), 1, 1e-12);
  EXPECT_EQ(all["status"], "undeclared");
  const auto one = result_of(plain, "--h h --error h1 --expect 1");
  ASSERT_EQ(one["fits"].size(), 1u);
  EXPECT_EQ(one["fits"][0]["verdict"], "pass");
  EXPECT_EQ(one["status"], "pass");
}

TEST(Judge, ExitCodesAreThoseOfAllCommandsThatJudge) {
  EXPECT_EQ(judge(plain).code, 0);
  EXPECT_EQ(judge(plain, "--expect 2,1").code, 0);
  EXPECT_EQ(judge(plain, "--expect 2").code, 1);              // h1 fails
  EXPECT_EQ(judge(plain, "--error l2 --expect 1").code, 1);   // above
  EXPECT_EQ(judge("0.4 0.3\n0.2 0.1\n").code, 1);             // too few levels
  EXPECT_EQ(judge("0.4,1\n0.2,2\n0.1,4\n0.05,8\n").code, 1);  // divergent
  EXPECT_EQ(judge("0.4,1\n0.2,nan\n0.1,4\n0.05,8\n").code, 2);
  EXPECT_EQ(judge(plain, "--error l3").code, 2);
  EXPECT_EQ(judge(plain, "--expect 2,1,1").code, 2);
  EXPECT_EQ(judge("").code, 2);
  EXPECT_EQ(judge("0.4,1\n0.2\n").code, 2);
  EXPECT_EQ(judge("0.4\n0.2\n").code, 2);
}

TEST(Judge, TablesAsPeopleKeepThem) {
  for (const char* text :
       {"0.4 0.32\n0.2 0.08\n0.1 0.02\n0.05 0.005\n",                            // blanks, no heading
        "0.4\t0.32\n0.2\t0.08\n\n0.1\t0.02\n0.05\t0.005\n",                      // tabs, an empty line
        "# errors\n0.05, 0.005 # finest\n0.1, 0.02\n0.4, 0.32\n0.2, 0.08\n",     // comments, any sequence
        "\"h [m]\";\"L2\"\r\n0,4;0,32\r\n0,2;0,08\r\n0,1;2,0e-2\r\n0,05;0,005",  // a spreadsheet of Europe
        "\xef\xbb\xbfh,L2\n4e-1,+0.32\n2e-1,0.08\n1e-1,0.02\n5e-2,5e-3\n"}) {
    const auto result = result_of(text, "--expect 2");
    ASSERT_EQ(result["fits"].size(), 1u) << text;
    EXPECT_NEAR(result["fits"][0]["order"].get<double>(), 2, 1e-12) << text;
    EXPECT_EQ(result["status"], "pass") << text;
  }
  EXPECT_EQ(result_of("a,\"h (mm)\"\n0.32,4\n0.08,2\n0.02,1\n0.005,0.5\n", "--h h")["fits"][0]["norm"], "a");
}

// Ratios other than 2: 3 h^1.5 on 1, 0.7, 0.4, 0.1.
TEST(Judge, AnyRatios) {
  std::string text;
  for (const double h : {1.0, 0.7, 0.4, 0.1})
    text += std::to_string(h) + "," + std::to_string(3 * std::pow(h, 1.5)) + "\n";
  EXPECT_NEAR(result_of(text)["fits"][0]["order"].get<double>(), 1.5, 1e-5);
}

// Runs of one level: geometric mean 0.02 sqrt(1.2 * 0.8) and so on, spread sqrt(2) 0.2 of the mean.
TEST(Judge, RunsOfALevelAreTakenTogether) {
  std::string text = "h,e\n";
  for (const double h : {0.4, 0.2, 0.1, 0.05})
    for (const double factor : {1.2, 0.8})
      text += std::to_string(h) + "," + std::to_string(factor * h * h) + "\n";
  const auto fit = result_of(text, "--expect 2")["fits"][0];
  EXPECT_EQ(fit["levels"], 4);
  EXPECT_NEAR(fit["order"].get<double>(), 2, 1e-4);  // six decimals were written
  ASSERT_EQ(fit["rows"].size(), 4u);
  EXPECT_EQ(fit["rows"][0]["runs"], 2);
  EXPECT_NEAR(fit["rows"][0]["error"].get<double>(), 0.16 * std::sqrt(0.96), 1e-6);
  EXPECT_NEAR(fit["rows"][0]["spread"].get<double>(), std::sqrt(2) * 0.2, 1e-6);
}

// 1 + 3 h^2: order 2, limit 1, relative index 1.25 (0.12 - 0.03)/3 over 1.03.
TEST(Judge, ValuesWithoutALimitAreExtrapolated) {
  const auto result = result_of("h;tip\n0,4;1,48\n0,2;1,12\n0,1;1,03\n", "--limit unknown");
  EXPECT_NEAR(result["order"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(result["limit"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(result["gci"][0].get<double>(), 1.25 * 0.03 / 1.03, 1e-9);
  EXPECT_EQ(result["column"], "tip");
  const auto noisy = result_of("4 1.118\n3 1.08\n2 1.049\n1.5 1.032\n1 1.021\n", "--limit unknown");
  EXPECT_NEAR(noisy["uncertainty"].get<double>(), 0.0228994832, 2e-7);
  EXPECT_EQ(judge(plain, "--limit unknown").code, 2);  // two columns
  EXPECT_EQ(judge(plain, "--limit 3").code, 2);
}

TEST(Judge, MessagesNameThePlace) {
  EXPECT_NE(judge("h,e\n0.4,1\n0.2,x\n").error.find("table.csv:3: \"x\" in column 2 is no number"),
            std::string::npos);
  EXPECT_NE(judge("h,e\n0.4,1\n0.2,inf\n").error.find("table.csv:3: inf in column 2"), std::string::npos);
  EXPECT_NE(judge("h,e\n0.4,1\n0.2,1,3\n").error.find("table.csv:3: 3 cells, the first line has 2"),
            std::string::npos);
  EXPECT_NE(judge(plain, "--error l").error.find("Did you mean"), std::string::npos);
}

}  // namespace
}  // namespace plumb
