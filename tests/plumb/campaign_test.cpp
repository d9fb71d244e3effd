// `plumb campaign`: a finite-element code in Python as a foreign program, its mistakes, resuming, jobs for
// others.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_shell;
using test::TemporaryFolder;

const std::string file = PLUMBLINE_SOURCE_DIR "/verification/campaigns/finite_elements.toml";
const std::string solver = "/usr/bin/python3 @here@/finite_elements.py input.json";

test::Outcome campaign(const TemporaryFolder& folder, const std::string& options) {
  return run_shell("cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " campaign " + file +
                   " --out out " + options);
}

nlohmann::json with_mistake(const TemporaryFolder& folder, const std::string& mistake) {
  return nlohmann::json::parse(
      campaign(folder, "--json - --set 'campaign.command=" + solver + " " + mistake + "'").out);
}

std::string causes(const nlohmann::json& result) {
  std::string all;
  for (const auto& cause : result["causes"]) all += cause.get<std::string>() + '\n';
  return all;
}

TEST(Campaign, AForeignCodeIsRunAndJudgedAndNotRunTwice) {
  const TemporaryFolder folder;
  const auto outcome = campaign(folder, "--jobs 2 --json result.json");
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.error;
  const auto result = nlohmann::json::parse(test::content_of(folder / "result.json"));
  EXPECT_EQ(result["status"], "pass");
  ASSERT_EQ(result["levels"].size(), 4u);
  EXPECT_NEAR(result["fits"][0]["order"].get<double>(), 2, 0.05);
  for (const auto& level : result["levels"]) {
    EXPECT_GT(level["cpu_s"].get<double>(), 0);
    EXPECT_GT(level["peak_rss"].get<double>(), 1e6);  // a Python
    EXPECT_FALSE(level["recalled"].get<bool>());
  }
  EXPECT_EQ(result["levels"][0]["n"], 3 * 5);
  // one level is lost: only that one is run again
  std::filesystem::remove_all(folder / "out/h_0.25");
  const auto again = nlohmann::json::parse(campaign(folder, "--json -").out);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(again["levels"][k]["recalled"].get<bool>(), k != 1);
  EXPECT_EQ(again["fits"], result["fits"]);
  // other inputs are other runs
  const auto other = nlohmann::json::parse(campaign(folder, "--json - --set material.young='2 MPa'").out);
  for (const auto& level : other["levels"]) EXPECT_FALSE(level["recalled"].get<bool>());
}

TEST(Campaign, MistakesOfTheCodeFailWithTheirCause) {
  const TemporaryFolder folder;
  const auto load = with_mistake(folder, "load");
  EXPECT_EQ(load["status"], "fail");
  EXPECT_NE(causes(load).find("look at the load, the law and its constants inside"), std::string::npos)
      << causes(load);
  const auto units = with_mistake(folder, "units");
  EXPECT_EQ(units["status"], "fail");
  EXPECT_NE(causes(units).find("look at the load, the law and its constants inside"), std::string::npos)
      << causes(units);
  const auto late = with_mistake(folder, "late");
  EXPECT_EQ(late["status"], "fail");
  EXPECT_NE(causes(late).find("boundary"), std::string::npos) << causes(late);
}

TEST(Campaign, ARunThatBreaksIsAResult) {
  const TemporaryFolder folder;
  const auto outcome = campaign(
      folder,
      "--json - --set 'campaign.command=test @level@ = 2 && { echo no licence; exit 3; } || " + solver + "'");
  EXPECT_EQ(outcome.code, 1);
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["status"], "fail");
  EXPECT_TRUE(result["levels"][1]["failure"].is_null());
  const auto nothing = campaign(folder, "--json - --set 'campaign.command=echo nothing'");
  EXPECT_EQ(nlohmann::json::parse(nothing.out)["levels"][0]["failure"], "it left no result.csv");
  const auto broken = campaign(folder, "--json - --set 'campaign.command=echo no licence; exit 3'");
  EXPECT_EQ(nlohmann::json::parse(broken.out)["levels"][0]["failure"],
            "the command ended with 3: no licence");
}

// The lines of a list stand alone, as xargs and Slurm arrays take them.
TEST(Campaign, JobsForOthers) {
  for (const auto& [kind, start] :
       {std::pair("makefile", "make -s -C out"),
        {"list", "cd out && while read -r line; do sh -c \"$line\" </dev/null || exit 1; done < jobs.txt"}}) {
    const TemporaryFolder folder;
    ASSERT_EQ(campaign(folder, std::string("--jobs-as ") + kind).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "out/h_0.5/result.csv"));
    const auto ran = run_shell("cd '" + folder.path().string() + "' && " + start);
    ASSERT_EQ(ran.code, 0) << ran.error;
    const auto judged = campaign(folder, "--judge --json -");
    EXPECT_EQ(judged.code, 0) << judged.error;
    EXPECT_EQ(nlohmann::json::parse(judged.out)["status"], "pass");
  }
}

TEST(Campaign, BadFilesAreRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& options) {
    const auto outcome = campaign(folder, options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << options;
    return outcome.error;
  };
  EXPECT_NE(refused("--set 'campaign.command=run @spacing@'").find("placeholder"), std::string::npos);
  EXPECT_NE(refused("--set 'campaign.prepare=run @spacing@'").find("placeholder"), std::string::npos);
  EXPECT_NE(refused("--set campaign.template=lammps.in").find("lammps.in: @dt@ without a time step"),
            std::string::npos);
  EXPECT_NE(
      refused("--set campaign.template=lammps.in --set campaign.cfl=0.5").find("lammps.in \"@amplitude@\""),
      std::string::npos);
  EXPECT_NE(refused("--set campaign.spacings=[0.5,0.3]").find("does not divide"), std::string::npos);
  EXPECT_NE(refused("--set campaign.spacings=[0.5,1e-6]").find("cloud of 2e+12 points"), std::string::npos);
  EXPECT_NE(refused("--set campaign.template=nowhere.in").find("nowhere.in"), std::string::npos);
  EXPECT_NE(refused("--set campaign.speed=3").find("speed"), std::string::npos);
  EXPECT_NE(refused("--set campaign.result=../x.csv").find("is a path"), std::string::npos);
  EXPECT_NE(refused("--set campaign.cloud=cloud.stl").find("cloud.stl"), std::string::npos);
  EXPECT_NE(refused("--set campaign.spacings=[0.1,0.2]").find("coarse to fine"), std::string::npos);
  EXPECT_NE(refused("--set campaign.runs=3").find("jitter"), std::string::npos);
  EXPECT_NE(refused("--set parameters.stretch=7").find("stretch"), std::string::npos);
  EXPECT_NE(refused("--set expect.l7=2").find("l7"), std::string::npos);
}

// cfl h/c with c^2 = (lambda + 2 mu)/rho = 1346.15 m^2/s^2, and whole steps to the end.
TEST(Campaign, StepsFollowTheSpacing) {
  const TemporaryFolder folder;
  const auto outcome = campaign(
      folder,
      "--json - --set campaign.cfl=0.5 --set 'campaign.command=echo @dt@ @steps@; cp loads.csv result.csv'");
  const auto levels = nlohmann::json::parse(outcome.out)["levels"];
  const double c = std::sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000);
  for (const auto& level : levels) {
    const double steps = std::ceil(0.004 / (0.5 * level["d"].get<double>() / c));
    EXPECT_EQ(level["steps"].get<double>(), steps);
    EXPECT_NEAR(level["dt"].get<double>(), 0.004 / steps, 1e-18);
  }
  EXPECT_EQ(levels[3]["steps"], 5);
  EXPECT_NE(test::content_of(folder / "out/h_0.0625/messages.txt").find(" 5\n"), std::string::npos);
}

// A code that writes the exact field at whatever points it gets: random clouds in all formats, several runs a
// level.
TEST(Campaign, CloudsOfAllFormats) {
  const TemporaryFolder folder;
  for (const char* cloud : {"cloud.csv", "cloud.vtp", "cloud.data"}) {
    const auto outcome =
        campaign(folder, std::string("--json - --set campaign.cloud=") + cloud +
                             " --set campaign.jitter=0.2 --set campaign.runs=2 --set campaign.time='4 ms' "
                             "--set 'campaign.command=test -s @cloud@ && cp loads.csv result.csv'");
    const auto result = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(result["levels"].size(), 8u) << outcome.error;
    for (const auto& level : result["levels"]) {
      EXPECT_TRUE(level["failure"].is_null()) << level["failure"];
      EXPECT_LT(level["l2"].get<double>(), 1e-15);
      EXPECT_NEAR(level["volume"].get<double>(), 2, 1e-9);
    }
  }
}

}  // namespace
}  // namespace plumb
