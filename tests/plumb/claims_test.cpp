#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "places.hpp"
#include "tests/support/program.hpp"

// The ledger of claims and what guards it. The numbers themselves are measured again by ctest -L claims.
namespace plumb {
namespace {

using Json = nlohmann::json;
const std::string root = PLUMBLINE_SOURCE_DIR;

Json ledger() {
  const auto outcome = test::run_plumb("claims --json - --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return Json::parse(outcome.out).at("claims");
}

/// A ledger of one claim: the slope of X^2 at the first particle is wrong by 0.197 with the standard
/// estimate.
test::Outcome check(const std::string& status, double value, const std::string& more = "") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "one.toml")
      << "paper = \"000\"\n[[claim]]\nid = \"one\"\nwhere = \"4.1\"\nclaim = \"exact\"\n"
      << "published = \"0\"\nat_most = 1e-9\nstatus = \"" << status << "\"\n"
      << more << "[[claim.reading]]\nname = \"W1\"\nat = \"rows/estimator=standard;n=40/max\"\n"
      << "command = \"oned study --n 20,40 --field poly:1,0,1 --estimator standard\"\n"
      << "value = " << value << "\n";
  return test::run_plumb("claims --check --json - --ledger " + folder.path().string() + " --store " +
                         (folder / "store").string());
}

TEST(Ledger, HasFortyRowsAndNoneOpenInTheClosedSections) {
  const Json claims = ledger();
  EXPECT_GE(claims.size(), 40u);
  for (const auto& claim : claims) {
    const std::string where = claim.at("where"), status = claim.at("status");
    const bool closed = claim.at("paper") == "000" && std::regex_search(where, std::regex("^(4|5\\.[123])"));
    EXPECT_FALSE(closed && status == "open") << claim.at("id");
    for (const char* key : {"paper", "claim", "published", "ours", "evidence"})
      EXPECT_FALSE(claim.at(key).get<std::string>().empty()) << claim.at("id") << ": " << key;
  }
}

TEST(Ledger, WhatIsNotReproducedHasThreeReadingsAndSecondEvidence) {
  for (const auto& claim : ledger()) {
    const std::string status = claim.at("status");
    if (status == "reproduced") continue;
    // what is said to be wrong needs three readings; one that is open or depends on the reading may have
    // fewer
    const std::size_t least = status == "contradicted" || claim.at("paper") == "000" ? 3 : 1;
    EXPECT_GE(claim.at("readings").size(), least) << claim.at("id");
    EXPECT_FALSE(claim.at("finding").get<std::string>().empty()) << claim.at("id");
    const std::string evidence = claim.at("evidence");
    EXPECT_TRUE(status != "contradicted" || evidence.find("besides") != std::string::npos) << claim.at("id");
  }
}

TEST(Ledger, NamesTestsThatExist) {
  std::string sources;
  for (const char* folder : {"/tests", "/verification/studies"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root + folder))
      if (entry.path().extension() == ".cpp") sources += test::content_of(entry.path());
  for (const auto& claim : ledger())
    for (const auto& reading : claim.at("readings")) {
      std::string name = reading.at("test");
      if (name.empty()) continue;
      name = name.starts_with("study:") ? "\"" + name.substr(7) + "\""
                                        : std::regex_replace(name, std::regex("\\."), ", ");
      EXPECT_NE(sources.find(name), std::string::npos) << claim.at("id") << " " << name;
    }
}

TEST(Ledger, AChangedNumberFailsTheCheck) {
  const auto right = check("open", 0.196962), wrong = check("open", 0.19);
  EXPECT_EQ(right.code, 0) << right.out << right.error;
  EXPECT_EQ(wrong.code, 1) << wrong.error;
  EXPECT_NE(wrong.error.find("0.19 is recorded"), std::string::npos) << wrong.error;
}

TEST(Ledger, AStatusThatDoesNotFollowIsRefused) {
  for (const char* status : {"reproduced", "ambiguous", "contradicted"}) {
    const auto outcome = check(status, 0.196962, "second_evidence = \"by hand\"\n");
    EXPECT_EQ(outcome.code, 2) << status;
    EXPECT_NE(outcome.error.find("does not follow"), std::string::npos) << outcome.error;
  }
}

TEST(Ledger, ANumberThatTurnsTheStatusFailsTheCheck) {
  // recorded as exact, within a tolerance so wide that only the status can tell
  const auto outcome = check("reproduced", 1e-15, "finding = \"planted\"\n");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.error.find("the numbers make it \"open\""), std::string::npos) << outcome.error;
}

/// Columns of a series, read here a second time.
std::map<std::string, std::vector<double>> series_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line, cell;
  std::getline(in, line);
  std::vector<std::string> names;
  for (std::istringstream heading(line); std::getline(heading, cell, ',');) names.push_back(cell);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (const auto& name : names) {
      std::getline(cells, cell, ',');
      columns[name].push_back(std::stod(cell));
    }
  }
  return columns;
}

/// A reading over a window of a run, against the series of the same run.
TEST(Ledger, AWindowIsTheMeanOrTheLargestOfItsRows) {
  const test::TemporaryFolder folder;
  const std::string command =
      "run verification/scenes/spinning-plate.toml --set scene.end_time=0.02 "
      "--set body.particles=[5,5] --set output.every=0.001";
  ASSERT_EQ(test::run_shell("cd " + root + " && " PLUMB_EXECUTABLE " " + command + " --out " +
                            (folder / "run").string())
                .code,
            0);
  const auto series = series_of(folder / "run" / "series.csv");
  const auto &times = series.at("time [s]"), &strain = series.at("strain energy [J/m]");
  double sum = 0, largest = 0, count = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] < 0.01) continue;
    sum += strain[k];
    largest = std::max(largest, strain[k]);
    ++count;
  }
  ASSERT_GT(count, 5);
  ASSERT_GT(std::abs(strain.back() / (sum / count) - 1), 0.01) << "an instant is something else";
  std::ofstream ledger(folder / "one.toml");
  ledger
      << "paper = \"000\"\n[[claim]]\nid = \"one\"\nwhere = \"5.2\"\nclaim = \"swings\"\npublished = \"0\"\n"
      << "at_least = 0\nstatus = \"reproduced\"\n";
  for (const auto& [take, value] : {std::pair("mean", sum / count), {"largest", largest}})
    ledger << "[[claim.reading]]\nname = \"" << take << "\"\ntake = \"" << take
           << "\"\nfrom = \"10 ms\"\nat = \"strain energy [J/m]\"\n"
           << "command = \"" << command << "\"\ntolerance = 1e-6\nvalue = " << std::setprecision(12) << value
           << "\n";
  ledger.close();
  const auto outcome = test::run_plumb("claims --check --json - --threads 1 --root " + root + " --ledger " +
                                       folder.path().string() + " --store " + (folder / "store").string());
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(Json::parse(outcome.out).at("measured").size(), 2u);
}

TEST(Ledger, TheCheckShowsMeasuredBesideRecorded) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "one.toml")
      << "paper = \"000\"\n[[claim]]\nid = \"one\"\nwhere = \"4.1\"\nclaim = \"exact\"\npublished = "
         "\"0\"\nat_most = 1e-9\n"
      << "status = \"open\"\n[[claim.reading]]\nname = \"W1\"\nat = \"rows/estimator=standard;n=40/max\"\n"
      << "command = \"oned study --n 20,40 --field poly:1,0,1 --estimator standard\"\nvalue = 0.19\n";
  const auto outcome = test::run_plumb("claims --check --ledger " + folder.path().string() + " --store " +
                                       (folder / "store").string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(std::regex_replace(outcome.out, std::regex("\\s+"), " ")
                .find("W1: 0.19 (CHANGED: recorded 0.19, measured 0.19696"),
            std::string::npos)
      << outcome.out;
}

TEST(Ledger, AWidthOfHalfASpacingIsRefused) {
  const auto outcome = test::run_plumb(
      "explain " + root + "/verification/scenes/pulling-column-nu-45.toml --set method.beta=0.5");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("neighbours"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace plumb
