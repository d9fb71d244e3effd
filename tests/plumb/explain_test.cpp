#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;

json explained(const std::string& scene, const std::string& changes = "") {
  const auto outcome = run_plumb("explain " PLUMBLINE_SOURCE_DIR "/verification/scenes/" + scene + ".toml" +
                                 " --json - --threads 1 " + changes);
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return json::parse(outcome.out);
}

json about(const json& explanation, const std::string& topic) {
  for (const auto& statement : explanation["solves"])
    if (statement["topic"] == topic) return statement;
  ADD_FAILURE() << topic << " is not explained";
  return {{"text", ""}, {"theory", ""}};
}

json cost_of(const json& explanation, const std::string& part) {
  for (const auto& cost : explanation["costs"]["parts"])
    if (cost["part"] == part) return cost;
  ADD_FAILURE() << part << " has no cost";
  return {};
}

TEST(Explain, NamesThePartsWithTheirEquations) {
  const json paper = explained("bending-column");
  for (const auto& [topic, theory] : {std::pair("kernel", "THEORY (1.2)"),
                                      {"correction", "THEORY (2.2), (2.7)"},
                                      {"gradient", "THEORY (3.1), (3.5)"},
                                      {"material", "THEORY (4.1), (4.2), (4.3)"},
                                      {"momentum", "THEORY (5.1), (5.2)"},
                                      {"dissipation", "THEORY (6.1), (6.4)"},
                                      {"integrator", "THEORY (7.1)"}})
    EXPECT_EQ(about(paper, topic)["theory"], theory) << topic;
  const json other = explained("twisting-column-105-compatible", "--set 'body.particles=[3, 3, 13]'");
  EXPECT_EQ(about(other, "gradient")["theory"], "THEORY (11.1), (11.4)");
  EXPECT_EQ(about(other, "hourglass")["theory"], "THEORY (12.1), (12.2)");
}

// Which compatible table it is, why, and what it takes before that is spent.
TEST(Explain, SaysHowACompatibleTableIsMade) {
  const std::string small = "--set 'body.particles=[3, 3, 13]' ";
  const json closed = explained("twisting-column-105-compatible", small + "--set body.jitter=0");
  EXPECT_EQ(closed["compatible"]["table"], "closed-form");
  EXPECT_EQ(about(closed, "gradient")["theory"], "THEORY (11.9)-(11.12)");
  const json projected = explained("twisting-column-105-compatible", small);
  EXPECT_EQ(projected["compatible"]["table"], "projected");
  EXPECT_GT(projected["compatible"]["expected_cpu_s"], 0);
  EXPECT_NE(about(projected, "gradient")["text"].get<std::string>().find("because the particles are no"),
            std::string::npos);
  const auto text = run_plumb(
      "explain " PLUMBLINE_SOURCE_DIR "/verification/scenes/twisting-column-105-compatible.toml " + small);
  EXPECT_TRUE(text.out.starts_with("Set-up: the table is projected")) << text.out;
}

/// All equations that any scene's explanation cites stand in THEORY.
TEST(Explain, CitesEquationsThatExist) {
  std::string theory;
  for (const auto& page : std::filesystem::directory_iterator(PLUMBLINE_SOURCE_DIR "/lib/theory"))
    theory += test::content_of(page.path().string());
  const std::regex number(R"(\(([0-9]+\.[0-9]+)\))");
  std::size_t cited = 0;
  for (const char* scene : {"bending-column", "swinging-plate", "free_plate"}) {
    const json explanation = explained(scene);
    for (const auto& statement : explanation["solves"]) {
      const auto text = statement["theory"].get<std::string>();
      for (std::sregex_iterator match(text.begin(), text.end(), number), end; match != end; ++match, ++cited)
        EXPECT_NE(theory.find("\\tag{" + match->str(1) + "}"), std::string::npos)
            << match->str() << " of " << statement;
    }
  }
  EXPECT_GE(cited, 20u);
}

TEST(Explain, SaysWhatWasLeftOutAndWhatThatSaves) {
  const json without = explained("free_plate", "--set method.momentum=adjoint");
  const json jst = cost_of(without, "dissipation (jst)");
  EXPECT_EQ(jst["built"], false);
  // JST keeps a field of two components; its constants are one number a bond, shared or not
  EXPECT_GE(jst["bytes_per_particle"].get<double>(), 16);
  EXPECT_GT(jst["step_time_ratio"].get<double>(), 1.0);  // two more sums over all bonds cannot be free
  const json with = explained("free_plate", "--set method.momentum=adjoint --set jst.eta4=0.015625");
  EXPECT_EQ(cost_of(with, "dissipation (jst)")["built"], true);
  EXPECT_EQ(cost_of(with, "dissipation (jst)")["bytes_per_particle"], jst["bytes_per_particle"]);
}

TEST(Explain, SaysWhatItIsForWhenItEndsAndWhatItWrites) {
  const json column = explained("bending-column", "--set scene.max_steps=7");
  EXPECT_NE(column["shows"].get<std::string>(), "");
  EXPECT_EQ(about(column, "ends")["text"], "at t = 0.5 s, or after 7 steps");
  const auto writes = about(column, "writes")["text"].get<std::string>();
  EXPECT_NE(writes.find("energies and momenta against time"), std::string::npos) << writes;
  EXPECT_NE(writes.find("every 0.01 s"), std::string::npos) << writes;
  EXPECT_NE(about(explained("free_cube"), "writes")["text"].get<std::string>().find("a summary only"),
            std::string::npos);
}

/// Newton's method takes the steps of [implicit]; nothing of an integrator is told of it.
TEST(Explain, SaysHowNewtonsMethodGoes) {
  const std::string flag = "--set method.scheme=implicit --set body.spacing=0.005 ";
  for (const auto& [scene, solved] : {std::pair<std::string, std::string>{"flag-swinging", flag},
                                      {"flag-elements", "--set element.solve=newton "}}) {
    const json moving = explained(
        scene, solved + "--set implicit.dynamics=midpoint --set method.time_step=0.005 --set output.every=1");
    EXPECT_EQ(about(moving, "steps")["text"],
              "implicit midpoint rule, steps of 0.005 s, residual 1e-10 of the forces");
    EXPECT_EQ(moving["dt"], 0.005);
    EXPECT_EQ(moving["steps"], 2000);
    EXPECT_TRUE(moving["evaluations_per_step"].is_null());
    EXPECT_GT(moving["estimated_wall_s"], 0);
    EXPECT_EQ(moving["why_no_estimate"], "");
    EXPECT_EQ(moving.dump().find("evaluation a step"), std::string::npos);
  }
  const json resting = explained("flag-swinging", flag + "--set implicit.steps=20 --set output.every=1");
  EXPECT_EQ(
      about(resting, "steps")["text"],
      "equilibrium by Newton's method, 20 steps (halved and grown as needed), residual 1e-10 of the forces");
  EXPECT_EQ(resting["steps"], 20);
  const json large = explained("flag-swinging", flag + "--set body.spacing=0.0005");
  EXPECT_TRUE(large["estimated_wall_s"].is_null());
  EXPECT_EQ(large["why_no_estimate"],
            "no step was tried: " + std::to_string(2 * large["particles"].get<long>()) + " unknowns");
}

TEST(Explain, GivesLoadsAndSupportsInTheirUnits) {
  EXPECT_EQ(about(explained("flag-swinging", "--set body.spacing=0.005"), "loads")["text"],
            "gravity (0, -2) m/s^2");
  const std::string plate =
      "--set 'boundary.0.kind=displacement' --set 'boundary.0.displacement=[\"0\", \"1e-3*t\"]' ";
  EXPECT_NE(about(explained("flag-swinging", "--set body.spacing=0.005 " + plate), "supports")["text"]
                .get<std::string>()
                .find("displaced by (0, 1e-3*t) m ("),
            std::string::npos);
}

TEST(Explain, SaysWhyTheStepIsWhatItIs) {
  const auto reason = [](const std::string& changes) {
    return explained("free_plate", changes)["dt_reason"]["text"].get<std::string>();
  };
  EXPECT_NE(reason("").find("cfl = "), std::string::npos);
  EXPECT_NE(reason("--set method.time_step=1e-5").find("fixed by the scene"), std::string::npos);
  EXPECT_NE(reason("--set method.integrator=rk3 --set jst.eta4=0.5").find("dissipation bears"),
            std::string::npos);
}

/// The same warnings go to standard error of a run.
TEST(Explain, ShowsTheWarningsOfTheScene) {
  const std::string scene = PLUMBLINE_SOURCE_DIR "/verification/scenes/free_plate.toml";
  const auto text = run_plumb("explain " + scene + " --set method.integrator=rk3 --set jst.eta4=0.5");
  EXPECT_NE(text.out.find("\nMind: JST limits the time step"), std::string::npos) << text.out;
  const test::TemporaryFolder folder;
  const auto run =
      run_plumb("run " + scene + " --set method.integrator=rk3 --set jst.eta4=0.5 --set scene.max_steps=1" +
                " --out " + (folder / "out").string());
  EXPECT_NE(run.error.find("warning: JST limits the time step"), std::string::npos) << run.error;
}

}  // namespace
}  // namespace plumb
