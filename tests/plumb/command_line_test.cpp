#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLine, AloneSaysWhatToTryFirst) {
  const auto outcome = run_plumb("");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "Try first:")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "plumb list")) << outcome.out;
}

TEST(CommandLine, VersionNamesCommitAndBuild) {
  const auto outcome = run_plumb("--version");
  EXPECT_EQ(outcome.code, 0);
  for (const char* part : {"plumb ", "commit ", "build", "-O"})
    EXPECT_TRUE(contains(outcome.out, part)) << part << " is missing in " << outcome.out;
}

TEST(CommandLine, EveryCommandHasHelpWithAnExampleOfItself) {
  int commands = 0;
  for (const std::string& name : test::commands()) {
    const auto help = run_plumb(name + " --help");
    EXPECT_EQ(help.code, 0) << name;
    const std::string first = name.substr(0, name.find(' '));
    EXPECT_TRUE(contains(help.out, "Example: plumb " + first) ||
                contains(help.out, "Example: plumb-house " + first))
        << help.out;
    ++commands;
  }
  EXPECT_GE(commands, 20);
}

TEST(CommandLine, JsonOnStandardOutputIsAlone) {
  const auto outcome = run_plumb("list --threads 1 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const auto result = nlohmann::json::parse(outcome.out);  // throws if anything else is there
  EXPECT_TRUE(result["plumbline"].is_string());
  EXPECT_EQ(result["command"], "plumb list --threads 1 --json -");
  for (const char* key : {"commit", "compiler", "flags", "host_cores", "threads", "date"})
    EXPECT_TRUE(result["provenance"].contains(key)) << key;
  EXPECT_EQ(result["provenance"]["threads"], 1);
}

TEST(CommandLine, JsonToAFileLeavesTheTextOnStandardOutputAndQuietDoesNot) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "list.json").string();
  const auto outcome = run_plumb("list --json " + file);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "cubic"));
  EXPECT_TRUE(nlohmann::json::parse(test::content_of(file)).contains("provenance"));
  EXPECT_EQ(run_plumb("list --quiet --json " + file).out, "");
}

TEST(CommandLine, TheCommandOfAResultCanBeCopiedToAShell) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "it's $HOME.json").string();
  const std::string quoted = "'" + folder.path().string() + "/it'\\''s $HOME.json'";
  ASSERT_EQ(run_plumb("list --quiet --json " + quoted).code, 0);
  EXPECT_EQ(nlohmann::json::parse(test::content_of(file))["command"], "plumb list --quiet --json " + quoted);
}

/// Bad command lines: exit code 2, a message that says what is wrong, nothing on standard output.
struct BadCall {
  const char* arguments;
  const char* message;
  friend std::ostream& operator<<(std::ostream& out, const BadCall& call) { return out << call.arguments; }
};

class BadCommandLine : public testing::TestWithParam<BadCall> {};

TEST_P(BadCommandLine, IsRefusedWithAMessage) {
  const auto outcome = run_plumb(GetParam().arguments);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.error, GetParam().message)) << outcome.error;
}

INSTANTIATE_TEST_SUITE_P(All, BadCommandLine,
                         testing::Values(BadCall{"lst", "Did you mean \"list\"?"},
                                         BadCall{"frobnicate", "unknown command \"frobnicate\""},
                                         BadCall{"--versoin", "Did you mean \"--version\"?"},
                                         BadCall{"list --jsno -", "Did you mean \"--json\"?"},
                                         BadCall{"list --jsno=-", "unknown option \"--jsno\""},
                                         BadCall{"--quiet list", "unknown option \"--quiet\""},
                                         BadCall{"list more", "unexpected argument \"more\""},
                                         BadCall{"list --json", "--json"},
                                         BadCall{"list --json ''", "file name is empty"},
                                         BadCall{"list --json /no/such/f", "/no/such"},
                                         BadCall{"list --json /", "It is a folder"},
                                         BadCall{"list --threads 0", "\"0\" is not a whole"},
                                         BadCall{"list --threads -1", "\"-1\" is not a whole"},
                                         BadCall{"list --threads 1.5", "\"1.5\" is not a whole"},
                                         BadCall{"list --threads 99999999999999999999", "1024"},
                                         BadCall{"list --threads two", "\"two\" is not"}));

TEST(CommandLine, AFullDiskIsAFailureNotBadInput) {
  const auto outcome = run_plumb("list --json /dev/full");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.error, "No space left")) << outcome.error;
  const auto piped = test::run_shell(PLUMB_EXECUTABLE " list --json - >/dev/full");
  EXPECT_EQ(piped.code, 1);
}

}  // namespace
}  // namespace plumb
