// plumb-house has the commands that check Plumbline itself; `plumb` hands calls of them over.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/commands.hpp"

namespace plumb {
namespace {

using test::run_house;
using test::run_plumb;
using test::run_shell;

TEST(House, HasItsCommandsAndPlumbHandsThemOver) {
  const std::vector<std::string> house{"bench", "claims", "faults", "refusals"};
  auto listed = test::commands_of(PLUMB_EXECUTABLE "-house");
  std::erase(listed, "manual");
  EXPECT_EQ(listed, house);
  for (const std::string& command : house) {
    EXPECT_EQ(run_plumb(command + " --help").out, run_house(command + " --help").out);
    EXPECT_EQ(run_plumb("help " + command).out, run_house("help " + command).out);
    EXPECT_NE(run_plumb("").out.find(command), std::string::npos);
  }
  const auto outcome = run_plumb("faults --json - --threads 1");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["command"], "plumb-house faults --json - --threads 1");
}

TEST(House, ExitCodesAndMessagesAreHandedBack) {
  const auto outcome = run_plumb("bench --case nowhere");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.error.starts_with("plumb-house: ")) << outcome.error;
  EXPECT_NE(run_plumb("claim").error.find("Did you mean \"claims\"?"), std::string::npos);
}

/// Alone, as a user may have it, plumb says where the command is; it carries no Google Benchmark.
TEST(House, PlumbAloneSaysWhereTheCommandsAre) {
  const test::TemporaryFolder folder;
  std::filesystem::copy_file(PLUMB_EXECUTABLE, folder / "plumb");
  const std::string plumb = (folder / "plumb").string();
  const auto outcome = run_shell(plumb + " claims --check");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(
      outcome.error,
      "plumb: \"claims\" is a command of plumb-house. That program is not beside this one. Install the package "
      "plumbline-house, or build the target plumb-house.\n");
  EXPECT_EQ(run_shell(plumb + " list").code, 0);
  EXPECT_EQ(run_shell("ldd " + plumb).out.find("benchmark"), std::string::npos);
  EXPECT_NE(run_shell("ldd " PLUMB_EXECUTABLE "-house").out.find("benchmark"), std::string::npos);
}

}  // namespace
}  // namespace plumb
