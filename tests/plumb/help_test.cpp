#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "places.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::commands;
using test::listed;
using test::run_plumb;
using test::run_shell;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// An empty folder with `plumb` and the folder verification, as an example finds them.
struct Place {
  test::TemporaryFolder folder;
  Place() {
    std::filesystem::create_symlink(PLUMBLINE_SOURCE_DIR "/verification", folder / "verification");
    std::filesystem::create_symlink(PLUMB_EXECUTABLE, folder / "plumb");
    std::filesystem::create_symlink(PLUMB_EXECUTABLE "-house", folder / "plumb-house");
  }
  test::Outcome run(const std::string& line) const {
    return run_shell("cd '" + folder.path().string() + "' && PATH=.:$PATH && export OMP_NUM_THREADS=1 && " +
                     line);
  }
};

TEST(Help, EveryCommandHasAnExampleThatRuns) {
  const auto all = commands();
  EXPECT_GE(all.size(), 20u);
  for (const auto& command : all) {
    const auto help = run_plumb(command + " --help");
    ASSERT_EQ(help.code, 0) << command;
    const std::string first = command.substr(0, command.find(' '));
    const auto at =
        std::min(help.out.find("Example: plumb " + first), help.out.find("Example: plumb-house " + first));
    ASSERT_NE(at, std::string::npos) << help.out;
    const std::string line = help.out.substr(at + 9, help.out.find('\n', at) - at - 9);
    const auto outcome = Place().run(line);
    EXPECT_EQ(outcome.code, 0) << line << '\n' << outcome.error << outcome.out.substr(0, 2000);
  }
}

/// "plumb new" without a member is a question: the answer is its help.
TEST(Help, AGroupAloneSaysWhatItsHelpSays) {
  for (const char* group : {"new", "completion"})
    EXPECT_EQ(run_plumb(group).out, run_plumb(std::string(group) + " --help").out);
}

TEST(Help, WhatToTryFirstWorksInOrderInAnEmptyFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink(PLUMB_EXECUTABLE, folder / "plumb");
  const auto lines = listed(run_plumb("").out, "Try first:\n");
  EXPECT_GE(lines.size(), 4u);
  std::istringstream text(run_plumb("").out);
  std::size_t tried = 0;
  for (std::string line; std::getline(text, line) && line != "Commands:";) {
    if (!line.starts_with("  plumb ")) continue;
    const auto outcome =
        run_shell("cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 PATH=.:$PATH " + line.substr(2));
    EXPECT_EQ(outcome.code, 0) << line << '\n' << outcome.error;
    EXPECT_NE(outcome.out, "") << line;
    ++tried;
  }
  EXPECT_EQ(tried, lines.size());
}

/// What bash offers for the words typed so far; the last one is being typed.
std::set<std::string> completions(const std::string& words) {
  const auto outcome = run_shell(
      "bash --norc --noprofile -c 'eval \"$(" PLUMB_EXECUTABLE " completion bash)\"; COMP_WORDS=(" + words +
      R"x(); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _plumb; printf "%s\n" "${COMPREPLY[@]}"')x");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  std::set<std::string> all;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) all.insert(line);
  return all;
}

TEST(Completion, BashOffersCommandsMembersAndOptions) {
  EXPECT_EQ(completions("plumb exp"), std::set<std::string>{"explain"});
  EXPECT_EQ(completions("plumb oned st"), std::set<std::string>{"study"});
  EXPECT_EQ(completions("plumb oned study --est"), std::set<std::string>{"--estimator"});
  EXPECT_EQ(completions("plumb run --re"), std::set<std::string>{"--resume"});
  EXPECT_EQ(completions("plumb run scene.toml --quiet --re"), std::set<std::string>{"--resume"});
  EXPECT_TRUE(completions("plumb run --json --re").empty());  // a file name is expected there
  EXPECT_TRUE(completions("plumb run sc").empty());           // files: left to the shell
  EXPECT_TRUE(completions("plumb \"\"").contains("mms"));
}

TEST(Completion, BashKnowsEveryCommandOfTheHelp) {
  for (const auto& command : test::commands_of(PLUMB_EXECUTABLE)) {
    const auto space = command.find(' ');
    const auto offered = space == std::string::npos
                             ? completions("plumb \"\"")
                             : completions("plumb " + command.substr(0, space) + " \"\"");
    EXPECT_TRUE(offered.contains(space == std::string::npos ? command : command.substr(space + 1)))
        << command;
  }
}

TEST(Completion, ZshTakesTheScriptAndDefinesAFunctionForEveryCommand) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "_plumb").string();
  ASSERT_EQ(run_shell(PLUMB_EXECUTABLE " completion zsh > " + file).code, 0);
  const auto checked = run_shell("zsh -n " + file);
  EXPECT_EQ(checked.code, 0) << checked.error;
  // loaded as compinit does it; a call without a line to complete defines the functions and fails
  const auto defined =
      run_shell("cd " + folder.path().string() +
                " && zsh -f -c 'autoload -Uz compinit && fpath=(. $fpath) && compinit -u -D && "
                "autoload +X _plumb && _plumb 2>/dev/null; print -l ${(k)functions} ${_comps[plumb]}'");
  EXPECT_TRUE(contains(defined.out, "\n_plumb\n")) << defined.error;
  for (auto command : test::commands_of(PLUMB_EXECUTABLE)) {
    for (char& c : command)
      if (c == ' ') c = '_';
    EXPECT_TRUE(contains(defined.out, "_plumb_" + command + "\n")) << defined.out;
  }
}

class Manual : public testing::TestWithParam<const char*> {};

TEST_P(Manual, IsSoundRoffAndNamesEveryCommandAndItsExample) {
  const test::TemporaryFolder folder;
  const std::string name = GetParam(), program = PLUMB_EXECUTABLE + name.substr(5),
                    file = (folder / (name + ".1")).string();
  ASSERT_EQ(run_shell(program + " manual > " + file).code, 0);
  const auto lint = run_shell("mandoc -T lint -W warning " + file);
  EXPECT_EQ(lint.code, 0) << lint.out;
  const auto page = run_shell("mandoc -T ascii -O width=300 " + file + " | sed 's/.\\x08//g'");
  ASSERT_EQ(page.code, 0);
  EXPECT_TRUE(contains(page.out, name + " - ")) << page.out.substr(0, 300);
  for (const auto& command : test::commands_of(program)) {
    EXPECT_TRUE(contains(page.out, "   " + name + " " + command + "\n")) << command;
    const auto help = run_shell(program + " " + command + " --help").out;
    const auto at = help.find("Example: ");
    const std::string example = help.substr(at + 9, help.find('\n', at) - at - 9);
    EXPECT_TRUE(contains(page.out, " " + example + "\n")) << example;
  }
  EXPECT_TRUE(contains(page.out, "EXIT STATUS"));
}

INSTANTIATE_TEST_SUITE_P(All, Manual, testing::Values("plumb", "plumb-house"));

}  // namespace
}  // namespace plumb
