// One rule for all commands that judge: 0 pass (or nothing declared), 1 anything else, 2 bad input.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/convergence/words.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;

const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";

struct Case {
  std::string call, verdict, status;
  int code;
};

/// Calls with --json and compares verdict (of the first fit, or of the whole), status and exit code.
void check(const Case& one) {
  const auto outcome = run_plumb(one.call + " --json -");
  EXPECT_EQ(outcome.code, one.code) << one.call << '\n' << outcome.error;
  if (outcome.code == 2) return;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["status"], one.status) << one.call;
  const auto& verdict = result.contains("fits") ? result["fits"][0]["verdict"] : result["verdict"];
  EXPECT_EQ(verdict, one.verdict) << one.call;
  // the same words for people, and no number that is none
  const std::string text = run_plumb(one.call).out;
  EXPECT_NE(text.find(one.verdict), std::string::npos) << text;
  EXPECT_NE(text.find("status: " + one.status), std::string::npos) << text;
  EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

const std::string five =
    "extrapolate --spacings 0.125,0.0625,0.03125,0.015625,0.0078125 --reference 1e-12,0 ";
const std::string half = five + "--values 0.023766,0.016805,0.011883,0.0084024,0.0059414";
const std::string four = "extrapolate --spacings 0.1,0.05,0.025,0.0125 --reference 1e-12,0 ";

// Errors of a public 1D peridynamics code: L2 of order 1/2 in every pair, H1 that grows, and round-off.
TEST(Verdicts, ErrorsAgainstAReferenceAreJudged) {
  for (const Case& one :
       std::vector<Case>{{half, "asymptotic", "undeclared", 0},
                         {half + " --order 0.5", "pass", "pass", 0},
                         {half + " --order 2", "fail", "fail", 1},
                         {half + " --order 0.3", "above", "inconclusive", 1},
                         {five + "--values 1.1497,1.4641,1.946,2.6597,3.6943", "divergent", "divergent", 1},
                         {five + "--values 1.1497,1.4641,1.946,2.6597,3.6943 --order 1", "fail", "fail", 1},
                         {five + "--values 1.0082e-15,1.2286e-14,7.7143e-14,1.3192e-13,9.8365e-13",
                          "noise-floor", "undeclared", 0},
                         {five + "--values 1.0082e-15,1.2286e-14,7.7143e-14,1.3192e-13,9.8365e-13 --order 1",
                          "noise-floor", "inconclusive", 1},
                         {four + "--values 1e-2,5e-3,2.5e-3,1.25e-3 --order 2", "fail", "fail", 1},
                         {four + "--values 1e-2,5e-3,2.5e-3,1.25e-3 --order 1", "pass", "pass", 0},
                         {"extrapolate --spacings 0.1,0.05,0.025 --values 1e-3,0,6.2e-5 --reference 1e-12,0",
                          "too-few-levels", "too-few-levels", 1},
                         {"extrapolate --spacings 0.1 --values 1e-3 --reference 1e-12,0 --order 2",
                          "too-few-levels", "inconclusive", 1}})
    check(one);
}

TEST(Verdicts, ANumberThatIsNoneIsBadInput) {
  for (const std::string& call :
       {four + "--values 1e-2,nan,2.5e-3,1.25e-3", four + "--values 1e-2,nan,2.5e-3,1.25e-3 --order 2",
        four + "--values 1e-2,inf,2.5e-3,1.25e-3",
        std::string("extrapolate --spacings 0.4,0.2,0.1 --values 1,nan,1.1"),
        std::string("extrapolate --spacings 0.4,0.2,0.1 --values 1,1.2,1.1 --reference 1e-12,nan")})
    EXPECT_EQ(run_plumb(call).code, 2) << call;
}

TEST(Verdicts, OfStudiesInOneDimension) {
  const std::string cubic = "oned study --field poly:1,0,0,1 --n ";
  for (const Case& one : std::vector<Case>{
           {cubic + "40,80,160,320,640 --estimator improved --pair W1", "asymptotic", "undeclared", 0},
           {cubic + "40,80,160,320,640 --estimator bond --pair W1", "stalled", "undeclared", 0},
           {cubic + "40,80,160,320,640 --estimator standard --pair none", "divergent", "divergent", 1},
           {cubic + "20,40,80 --estimator improved --pair W1", "too-few-levels", "too-few-levels", 1},
           {cubic + "20 --estimator improved --pair W1", "too-few-levels", "too-few-levels", 1}})
    check(one);
}

TEST(Verdicts, OfStudiesWithManufacturedSolutions) {
  const std::string four_levels = " --set study.spacings=[0.2,0.125,0.1,0.0625]",
                    two_levels = " --set study.spacings=[0.5,0.25]",
                    plate = "mms " + studies + "swinging_plate.toml --set study.quadrature=nodal",
                    lattice = "static " + studies + "static_plate.toml --set body.jitter=0",
                    column = "mms " + studies + "stretched_column.toml";
  for (const Case& one : std::vector<Case>{
           {plate + two_levels, "too-few-levels", "inconclusive", 1},
           {plate + four_levels + " --set expect.l2=4", "fail", "fail", 1},
           {plate + four_levels + " --set expect.l2=1", "above", "inconclusive", 1},
           {lattice + two_levels, "too-few-levels", "inconclusive", 1},
           {lattice + four_levels, "pass", "pass", 0},
           {lattice + four_levels + " --set expect.l2=4", "fail", "fail", 1},
           {lattice + four_levels + " --set expect.l2=0.5", "above", "inconclusive", 1},
           {column + two_levels, "too-few-levels", "too-few-levels", 1},
           {"operators " + studies + "operators.toml --set study.spacings=[0.1,0.05]", "too-few-levels",
            "too-few-levels", 1},
           {"operators " + studies + "operators.toml --set study.spacings=[0.1,0.0625,0.05,0.04]",
            "asymptotic", "undeclared", 0}})
    check(one);
}

TEST(Verdicts, EveryWordIsExplainedInOnePlace) {
  const auto outcome = run_plumb("verdicts");
  ASSERT_EQ(outcome.code, 0);
  const std::string manual = run_plumb("manual").out;
  for (const VerdictWord& one : verdict_words) {
    EXPECT_NE(outcome.out.find(std::string(one.word) + "\n    " + std::string(one.meaning)),
              std::string::npos)
        << one.word;
    const std::string start(one.meaning.substr(0, one.meaning.find_first_of("-:;.,")));
    EXPECT_NE(manual.find(start), std::string::npos) << one.word;
  }
  const auto rows = nlohmann::json::parse(run_plumb("verdicts --json -").out)["rows"];
  EXPECT_EQ(rows.size(), verdict_words.size());
  for (const char* command : {"mms", "static", "operators", "oned study", "extrapolate"})
    EXPECT_NE(run_plumb(std::string(command) + " --help").out.find("plumb verdicts"), std::string::npos)
        << command;
}

TEST(Verdicts, AWordThatIsNoPassIsExplainedBelowTheOrders) {
  const auto outcome = run_plumb(half + " --order 0.3");
  EXPECT_NE(outcome.out.find(std::string(meaning_of("above"))), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace plumb
