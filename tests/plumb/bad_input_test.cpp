// The table of bad inputs (verification/bad_inputs.toml) holds the very words that a user sees.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

TEST(BadInput, IsToldInTheWordsOfTheTable) {
  const auto outcome = test::run_shell("cd " PLUMBLINE_SOURCE_DIR " && " PLUMB_EXECUTABLE
                                       " refusals verification/bad_inputs.toml --json -");
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_GE(result["count"], 80);
  for (const auto& row : result["rows"]) EXPECT_TRUE(row["as_written"].get<bool>()) << row.dump(1);
  EXPECT_EQ(outcome.code, 0) << outcome.error;
}

TEST(BadInput, AnotherMessageIsSeen) {
  const test::TemporaryFolder folder;
  const auto table = folder / "table.toml";
  std::ofstream(table)
      << "scene = \"x = 1\"\nstudy = \"y\"\n[[bad]]\nwhat = \"one\"\nmessage = \"plumb: something else\"\n";
  const auto outcome = test::run_plumb("refusals " + table.string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("1 bad inputs, 1 with another message"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace plumb
