// A table of many bodies does not end because one of them cannot be built: it is a row that says why.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::refused_rows_test {
namespace {

using nlohmann::json;
using test::run_plumb;
const std::string plate = PLUMBLINE_SOURCE_DIR "/verification/scenes/free_plate.toml";
const std::string compatible =
    " --set method.gradient=compatible --set body.layout=node --set body.jitter=0.3";

TEST(RefusedRows, OfASpectrum) {
  const auto outcome = run_plumb("spectrum " + plate + compatible + " --over method.beta=0.55,0.9 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json rows = json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["method.beta"], "0.55");
  EXPECT_EQ(rows[0]["status"].get<std::string>().rfind("refused: ", 0), 0u) << rows[0];
  EXPECT_TRUE(rows[0]["lowest_nonrigid"].is_null());
  EXPECT_TRUE(rows[0]["negative"].is_null()) << "not zero: nothing was found";
  EXPECT_FALSE(rows[1].contains("status"));
  EXPECT_GT(rows[1]["lowest_nonrigid"].get<double>(), 0);
}

TEST(RefusedRows, OfASpectrumAreBadInputIfThereAreNoOthers) {
  const auto outcome = run_plumb("spectrum " + plate + compatible + " --over method.beta=0.5,0.55 --json -");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(json::parse(outcome.out)["kind"], "error");
}

/// A scheme that can be built on cell layouts, and one that cannot: fixed volumes do not meet its
/// constraints.
const std::string improved = "[[variant]]\nname = \"improved\"\n",
                  own =
                      "[[variant]]\nname = \"own\"\nset = [\"method.gradient=compatible\", "
                      "\"compatible.volumes=fixed\"]\n";

/// A map of them over two widths of the kernel.
test::Outcome map_of(const std::string& variants, const std::string& options = "") {
  const test::TemporaryFolder folder;
  const auto file = folder / "study.toml";
  std::ofstream(file) << "[stability]\nscene = \"" + plate + "\"\n" + R"toml(
set = ["scene.end_time=1 ms"]
parameter = "cfl"
from = 0.2
to = 0.3
over = "method.beta"
values = [0.9, 1.2]
)toml" + variants;
  return run_plumb("stability " + file.string() + " --cache '' --json -" + options);
}

TEST(RefusedRows, OfAMapOfStability) {
  const auto outcome = map_of(improved + own);
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json rows = json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) {
    const bool refused = row["variant"] == "own" && row["x"] == 0.9;
    EXPECT_EQ(row["cause"] == "refused", refused) << row;
    EXPECT_EQ(row.contains("status"), refused) << row;
    EXPECT_EQ(row["limit"].is_null(), refused) << row;
  }
}

TEST(RefusedRows, OfAMapAreBadInputIfThereAreNoOthers) {
  const auto outcome = map_of(own, " --set stability.values=[0.9]");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("no scene of the study"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace plumb::refused_rows_test
