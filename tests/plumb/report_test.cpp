#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/browser.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;
namespace fs = std::filesystem;

TEST(Report, MakesOnePageWhoseLinksAllLead) {
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("report --quiet --only kernels,response --out " + folder.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const std::string page = test::content_of(folder / "index.html");
  const std::regex link("href=\"([^\"#:]+)\"");
  std::size_t links = 0;
  for (std::sregex_iterator m(page.begin(), page.end(), link), end; m != end; ++m, ++links)
    EXPECT_TRUE(fs::exists(folder / (*m)[1].str())) << (*m)[1];
  EXPECT_GT(links, 10u);
  EXPECT_NE(page.find("plumb oned kernels --at 0"), std::string::npos);
}

/// Every link and anchor of a page leads somewhere, and the browser finds nothing wrong with it.
void check_page(const fs::path& folder, int width, const std::string& page) {
  const auto seen = test::Browser().open(page, width, test::reader);
  EXPECT_EQ(seen["console"], "");
  EXPECT_EQ(seen["frame"], width);
  EXPECT_LE(seen["overflow"], 0) << "wider than " << width;
  for (const char* bad : {"lost", "twice", "unsorted", "unfiltered", "stuck"})
    EXPECT_TRUE(seen[bad].empty()) << bad << ": " << seen[bad];
  const std::regex link("href=\"([^\"#:]+)\"");
  for (std::sregex_iterator m(page.begin(), page.end(), link), end; m != end; ++m)
    EXPECT_TRUE(fs::exists(folder / (*m)[1].str())) << (*m)[1];
}

TEST(Report, WorksInTheBrowserOnATelephoneADeskAndPaper) {
  if (!test::Browser::installed())
    FAIL() << "chromium or pdftotext is not installed: both are in .ci/packages.txt";
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("report --quiet --only kernels,account,claims,faults,bad-input --out " +
                                 folder.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const std::string page = test::content_of(folder / "index.html");
  for (const int width : {400, 1600}) check_page(folder.path(), width, page);
  int words = 0, outside = 0;
  test::Browser().print(page, words, outside);
  EXPECT_GT(words, 3000);
  EXPECT_EQ(outside, 0) << "words are cut at the edge of the paper";
}

/// The complete report, if one was made: PLUMB_REPORT names its folder (reports/out of the tree if it is not
/// set).
TEST(Report, LongCompletePageWorksInTheBrowser) {
  if (!test::Browser::installed())
    FAIL() << "chromium or pdftotext is not installed: both are in .ci/packages.txt";
  const char* named = std::getenv("PLUMB_REPORT");
  const fs::path folder = named ? fs::path(named) : fs::path(PLUMBLINE_SOURCE_DIR) / "reports" / "out";
  if (!fs::exists(folder / "index.html")) {
    const auto outcome = run_plumb("report --quiet --out " + folder.string());
    ASSERT_LE(outcome.code, 1) << outcome.error;
  }
  const std::string page = test::content_of(folder / "index.html");
  for (const int width : {400, 1600}) check_page(folder, width, page);
  int words = 0, outside = 0;
  test::Browser().print(page, words, outside);
  EXPECT_EQ(outside, 0) << "words are cut at the edge of the paper";
}

TEST(Report, SecondCallUsesStoredResults) {
  const test::TemporaryFolder folder;
  const std::string call = "report --quiet --only kernels --out " + folder.path().string() + " --json -";
  EXPECT_EQ(nlohmann::json::parse(run_plumb(call).out)["reused"], 0);
  const auto second = nlohmann::json::parse(run_plumb(call).out);
  EXPECT_EQ(second["reused"], second["studies"]);
}

/// Every number of the JSON, counted again from its rows and from what lies in the folder.
TEST(Report, JsonCountsWhatItsRowsAndItsFolderHold) {
  using nlohmann::json;
  const test::TemporaryFolder folder;
  const std::string out = folder.path().string();
  const auto result =
      json::parse(run_plumb("report --quiet --only kernels,account --json - --out " + out).out);
  EXPECT_EQ(result["page"], (folder / "index.html").string());
  std::map<std::string, int> all, passed, verdicts;
  for (const auto& row : result["rows"]) {
    const bool pass = row["verdict"] == "pass";
    ++all[row["kind"]];
    passed[row["kind"]] += pass ? 1 : 0;
    ++verdicts[row["verdict"]];
    for (const char* key : {"section", "what", "expected", "measured"})
      EXPECT_FALSE(row[key].get<std::string>().empty()) << key << ": " << row;
  }
  EXPECT_FALSE(all.empty());
  for (const auto& [kind, count] : result["kinds"].items()) {
    EXPECT_EQ(count["all"], all[kind]) << kind;
    EXPECT_EQ(count["pass"], passed[kind]) << kind;
  }
  for (const auto& [verdict, count] : result["verdicts"].items())
    EXPECT_EQ(count, verdicts[verdict]) << verdict;
  EXPECT_TRUE(result["problems"].empty());
  EXPECT_GT(result["studies"], 0);
  EXPECT_EQ(result["reused"], 0);
  EXPECT_GT(result["cpu_s"].get<double>(), 0);
}

TEST(Report, UnknownSectionNamesTheNearest) {
  const auto outcome = run_plumb("report --only kernel");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("kernels"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace plumb
