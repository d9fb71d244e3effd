#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::content_of;
using test::run_plumb;

std::string written(const std::string& kind, const std::filesystem::path& file) {
  const auto outcome = run_plumb("new " + kind + " " + file.string());
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return content_of(file);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

TEST(New, ASceneRunsAsItIs) {
  const test::TemporaryFolder folder;
  const auto text = written("scene", folder / "mine.toml");
  EXPECT_NE(text.find("name = \"mine\""), std::string::npos);
  EXPECT_EQ(text.find('@'), std::string::npos) << "a mark was left";
  const auto outcome =
      run_plumb("run " + (folder / "mine.toml").string() +
                " --set scene.max_steps=5 --json - --quiet --out " + (folder / "out").string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["steps"], 5);
}

TEST(New, AStudyRunsAndTheOrderThatItDeclaresComesOut) {
  const test::TemporaryFolder folder;
  written("study", folder / "mine.toml");
  const auto outcome = run_plumb("mms " + (folder / "mine.toml").string() + " --quiet --threads 1 --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["status"], "pass");
}

/// Who takes one for the other is told so.
TEST(New, ASceneIsNoStudy) {
  const test::TemporaryFolder folder;
  written("study", folder / "order.toml");
  written("scene", folder / "first.toml");
  EXPECT_NE(run_plumb("run " + (folder / "order.toml").string()).error.find("this file is a study"),
            std::string::npos);
  EXPECT_NE(run_plumb("mms " + (folder / "first.toml").string()).error.find("this file is a scene"),
            std::string::npos);
}

TEST(New, AddsTheEndingAndNeverOverwrites) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(run_plumb("new scene " + (folder / "mine").string()).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "mine"));
  write(folder / "mine.toml", "precious");
  const auto outcome = run_plumb("new scene " + (folder / "mine").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("exists"), std::string::npos) << outcome.error;
  EXPECT_EQ(content_of(folder / "mine.toml"), "precious");
}

TEST(New, RefusesANameThatWouldSpoilTheFile) {
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("new scene '" + (folder / "a\"b").string() + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("cannot be a name"), std::string::npos) << outcome.error;
  EXPECT_EQ(run_plumb("new scene /no/such/folder/x").code, 2);
}

/// Every setting that stands in a comment can be used by taking the "#" away: alone, or with its section.
TEST(New, EverySettingInACommentIsValid) {
  const test::TemporaryFolder folder;
  const auto file = folder / "mine.toml";
  const auto text = written("scene", file);
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const std::regex setting("# [a-z_0-9]+ = .*"), section("# \\[.*");
  std::size_t tried = 0;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    auto changed = lines;
    if (std::regex_match(lines[n], section))
      for (std::size_t m = n; m < lines.size() && lines[m].starts_with("# "); ++m)
        changed[m] = lines[m].substr(2);
    else if (std::regex_match(lines[n], setting) && !(n > 0 && lines[n - 1].starts_with("# [")) &&
             !(n > 1 && lines[n - 2].starts_with("# [")))
      changed[n] = lines[n].substr(2);
    else
      continue;
    std::string whole;
    for (const auto& line : changed) whole += line + "\n";
    write(file, whole);
    const auto outcome =
        run_plumb("run " + file.string() + " --set scene.max_steps=2 --quiet --threads 1 --out " +
                  (folder / "out").string());
    EXPECT_EQ(outcome.code, 0) << lines[n] << '\n' << outcome.error;
    ++tried;
  }
  EXPECT_GE(tried, 8u);
}

}  // namespace
}  // namespace plumb
