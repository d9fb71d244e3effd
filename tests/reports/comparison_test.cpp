// The schemes side by side: what the table of problems and schemes says, and what is read of a run.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"
#include "reports/comparison/tables.hpp"
#include "reports/named.hpp"
#include "tests/reports/comparison_given.hpp"

namespace {

using namespace plumb::side_by_side_tests;

TEST(Comparison, CallsOfAStudyAndOfAScene) {
  const Table t = table();
  const auto one = jobs_of(by_id(t.problems, "plate"), by_id(t.schemes, "x"));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].id, "five-plate-x");
  EXPECT_EQ(one[0].arguments,
            (std::vector<std::string>{"mms", "plate.toml", "--set", "material.poisson=0.4", "--set",
                                      "method.scheme=mixed", "--set", "mixed.upwind=none", "--set",
                                      "study.spacings=[0.2,0.1]"}));
  EXPECT_EQ(one[0].inputs, std::vector<std::string>{"plate.toml"});
  const auto two = jobs_of(by_id(t.problems, "bar"), by_id(t.schemes, "x"));
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[1].id, "five-bar-x-2");
  EXPECT_EQ(two[1].arguments,
            (std::vector<std::string>{"run", "bar.toml", "--set", "method.scheme=mixed", "--set",
                                      "implicit.dynamics=midpoint", "--set", "body.spacing=0.25", "--set",
                                      "implicit.time_step=0.0025", "--out", "{out}"}));
  // what is refused is asked once
  EXPECT_EQ(jobs_of(by_id(t.problems, "bar"), by_id(t.schemes, "x-printed")).size(), 1u);
  EXPECT_EQ(jobs_of(t).size(), 3u + 1 + 2 + 2);
  EXPECT_EQ(by_id(table(Extent::long_run).problems, "plate").spacings, (std::vector<double>{0.2, 0.1, 0.05}));
}

/// The smallest report has the problems that say so.
TEST(Comparison, TheCoreHasWhatSaysSo) {
  std::string text = schemes + plate + bar;
  text.replace(text.find("id = \"plate\""), 12, "id = \"plate\"\ncore = true");
  const Table core = read_table(text, "table.toml", Extent::core);
  ASSERT_EQ(core.problems.size(), 1u);
  EXPECT_EQ(core.problems[0].id, "plate");
  EXPECT_EQ(read_table(text, "table.toml", Extent::full).problems.size(), 2u);
}

/// What is wrong in a table is refused with its line.
TEST(Comparison, RefusesWhatIsWrong) {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& words) {
    std::string text = schemes + plate + bar;
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
      read_table(text, "table.toml", Extent::full);
      ADD_FAILURE() << "took " << to;
    } catch (const plumb::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("table.toml:"), std::string::npos) << error.what();
    }
  };
  refused(R"(schemes = ["x-printed"])", R"(schemes = ["y"])", "there is no scheme \"y\"");
  refused("schemes = [\"x-printed\"]\nrefuses", "schemes = [\"x-printed\", \"x\"]\nrefuses",
          "has a cell already");
  refused("truth = [1, 2]", "truth = [1, 2]\nhalf_swing_of = \"y\"", "it is not said how it is read");
  refused("at = [\"/probes/tip/position/0\", \"/probes/tip/position/1\"]\n", "",
          "it is not said how it is read");
  refused("spacings = [0.5, 0.25]", "spacings = [0.25, 0.5]", "they do not go from coarse to fine");
  refused("scene = \"bar.toml\"", "scene = \"bar.toml\"\nstudy = \"bar.toml\"", "a study or a scene");
  refused(R"(beside = "plate")", R"(beside = "dish")", "there is no problem \"dish\"");
  refused(R"(id = "bar")", R"(id = "plate")", "\"plate\" is there twice");
  refused(R"(id = "bar")", "id = \"bar\"\ncore = true",
          "problem \"plate\", which it is beside, is not in the core");
  refused("free = true", "fre = true", "fre");
}

/// Numbers of others are shown with their distance from the truth over the scale.
TEST(Comparison, NumbersOfOthers) {
  const std::string others = "[[problem.public]]\ncode = \"other\"\nvalue = 1.5\nnote = \"published\"\n";
  std::string text = schemes + bar + others;
  const std::string at = R"(at = ["/probes/tip/position/0", "/probes/tip/position/1"])";
  EXPECT_THROW(read_table(schemes + plate + bar + others, "table.toml", Extent::full), plumb::InputError);
  text.replace(text.find(at), at.size(), R"(at = ["/probes/tip/position/0"])");
  text.replace(text.find("[1, 2]"), 6, "[1]");
  text.replace(text.find("beside = \"plate\""), 16, "");
  const DataTable shown = public_numbers(read_table(text, "table.toml", Extent::full));
  ASSERT_EQ(shown.rows.size(), 1u);
  EXPECT_EQ(std::get<std::string>(cell_of(shown, shown.rows[0], "code")), "other");
  EXPECT_DOUBLE_EQ(std::get<double>(cell_of(shown, shown.rows[0], "value")), 1.5);
  EXPECT_DOUBLE_EQ(std::get<double>(cell_of(shown, shown.rows[0], "error")), 0.05);
}

TEST(Comparison, DistanceFromTheTruth) {
  const Quantity place{.in_words = "", .at = {"/a/0", "/a/1"}, .truth = {1, 2}, .scale = 10};
  EXPECT_DOUBLE_EQ(error_of(place, 0.1, {{"a", {4, 6}}}, {}).value(), 0.5);
  Quantity surface{.in_words = "", .at = {"/a"}, .plus_spacing = 0.5, .truth = {2}, .scale = 4};
  EXPECT_DOUBLE_EQ(error_of(surface, 0.4, {{"a", 1.0}}, {}).value(), 0.2);  // 1.2 in place of 2
  EXPECT_THROW(error_of(surface, 0.4, {{"b", 1.0}}, {}), MissingResult);
}

/// A turn is followed beyond 360 degrees, either way round.
TEST(Comparison, TurnsBeyondAWholeOne) {
  const Quantity turn{
      .in_words = "", .turn_of = {"u", "v"}, .turn_from = {1, 0}, .truth = {400}, .scale = 400};
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> u, v;
    for (int k = 0; k <= 4; ++k) {
      const double angle = sign * 90 * k * std::numbers::pi / 180;
      u.push_back(std::cos(angle) - 1), v.push_back(std::sin(angle));
    }
    EXPECT_NEAR(error_of(turn, 1, {}, {{"u", u}, {"v", v}}).value(), 0.1, 1e-12);  // 360 in place of 400
  }
}

TEST(Comparison, HalfASwing) {
  const Quantity swing{.in_words = "", .half_swing_of = "y", .truth = {5}, .scale = 5};
  // up, and through zero between 2 s and 3 s, a quarter of the way: twice 2.25 s
  const std::vector<double> time{0, 1, 2, 3, 4}, y{0, 2, 1, -3, 1};
  EXPECT_DOUBLE_EQ(error_of(swing, 1, {}, {{"time [s]", time}, {"y", y}}).value(), 0.1);
  EXPECT_FALSE(error_of(swing, 1, {}, {{"time [s]", time}, {"y", {0, 2, 1, 1, 1}}}).has_value());
  EXPECT_THROW(error_of(swing, 1, {}, {{"time [s]", time}}), MissingResult);
}

TEST(Comparison, RunTimeAtAnError) {
  // half way in the logarithm of the error, half way in that of the time
  EXPECT_NEAR(cost_at(with({{0.4, 1}, {0.1, 4}}), 0.2)->cpu_s, 2, 1e-12);
  EXPECT_FALSE(cost_at(with({{0.4, 1}, {0.1, 4}}), 0.2)->at_most);
  EXPECT_FALSE(cost_at(with({{0.4, 1}, {0.1, 4}}), 0.05).has_value());
  EXPECT_TRUE(cost_at(with({{0.4, 1}, {0.1, 4}}), 0.5)->at_most);
  EXPECT_DOUBLE_EQ(cost_at(with({{0.4, 1}, {0.1, 4}}), 0.5)->cpu_s, 1);
  // a small error by chance, and a larger one on the next spacing: only the last time counts
  EXPECT_NEAR(cost_at(with({{0.1, 1}, {0.4, 2}, {0.1, 8}}), 0.2)->cpu_s, 4, 1e-12);
  EXPECT_FALSE(cost_at(with({{0.1, 1}, {0.4, 2}}), 0.2).has_value());
  // behind a level that broke the run time is that of the finer one
  EXPECT_TRUE(cost_at(with({{{}, 1}, {0.1, 8}}), 0.2)->at_most);
  EXPECT_DOUBLE_EQ(cost_at(with({{{}, 1}, {0.1, 8}}), 0.2)->cpu_s, 8);
  EXPECT_FALSE(cost_at(with({{0.1, 1}, {{}, 8}}), 0.2).has_value());
}

TEST(Comparison, WhatBecameOfARun) {
  Given given;
  fill(given);
  const Table t = table();
  const auto outcome = [&](const char* problem, const char* scheme) {
    return outcome_of(given.results, by_id(t.problems, problem), by_id(t.schemes, scheme));
  };
  const Outcome bar = outcome("bar", "x");
  EXPECT_EQ(bar.state, State::ran);
  ASSERT_EQ(bar.levels.size(), 2u);
  EXPECT_DOUBLE_EQ(bar.levels[0].error.value(), 0.5);
  EXPECT_DOUBLE_EQ(bar.finest()->error.value(), 0.05);
  EXPECT_DOUBLE_EQ(bar.finest()->cpu_s.value(), 3);
  EXPECT_DOUBLE_EQ(bar.finest()->steps.value(), 40);
  EXPECT_NEAR(bar.fit.order, std::log2(10), 1e-12);
  EXPECT_DOUBLE_EQ(bar.bytes_per_particle.value(), 100);
  EXPECT_DOUBLE_EQ(bar.peak_rss.value(), 3e7);
  EXPECT_DOUBLE_EQ(bar.linear_drift.value(), 2e-16);
  EXPECT_DOUBLE_EQ(bar.angular_drift.value(), 1e-5);
  // of 100 J there are 90: 4 became heat, loads brought 1 and damping took 2, so 5 are not accounted for
  ASSERT_TRUE(bar.energy.has_value());
  EXPECT_NEAR(bar.energy->change, -0.1, 1e-15);
  EXPECT_NEAR(bar.energy->dissipated.value(), 0.04, 1e-15);
  EXPECT_NEAR(bar.energy->plastic, 0.2, 1e-15);
  EXPECT_NEAR(bar.energy->more, 0.05, 1e-15);
  EXPECT_NEAR(bar.energy->unexplained, -0.05, 1e-15);
  const Outcome refused = outcome("bar", "x-printed");
  EXPECT_EQ(refused.state, State::refused);
  EXPECT_EQ(refused.why, "the scheme has no bars. Use another.");
  EXPECT_FALSE(refused.finest().has_value());
  EXPECT_NEAR(outcome("plate", "x").fit.order, 2, 1e-12);
  EXPECT_FALSE(outcome("plate", "x").angular_drift.has_value());
}

/// One overview has the printed schemes, the other the mended ones; elements stand in both.
TEST(Comparison, OverviewsShowOneKindBesideTheElements) {
  Given given;
  fill(given);
  const Table t = table();
  const Outcomes outcomes = outcomes_of(given.results, t);
  const auto columns = [&](bool printed) {
    std::vector<std::string> names;
    for (const auto& column : overview(t, outcomes, printed).columns) names.push_back(column.name);
    return names;
  };
  EXPECT_EQ(columns(true), (std::vector<std::string>{"problem", "spacing", "x, printed", "elements"}));
  EXPECT_EQ(columns(false), (std::vector<std::string>{"problem", "spacing", "x, mended", "elements"}));
}

TEST(Comparison, WhatBreaksIsSaid) {
  Given given;
  fill(given);
  const Table t = table();
  Json broken = run(1, 2, 1);
  broken["status"] = "unstable";
  broken["failure"] = {{"cause", "inverted"}, {"time", 0.125}};
  given.add("five-bar-x-1", broken);
  const Outcome bar = outcome_of(given.results, by_id(t.problems, "bar"), by_id(t.schemes, "x"));
  EXPECT_EQ(bar.state, State::unstable);
  EXPECT_EQ(bar.why, "unstable: inverted at 0.125 s with d = 0.5 m");
  EXPECT_FALSE(bar.levels[0].error.has_value());
  EXPECT_FALSE(bar.sound());
  Json levels = study({{0.4, 1}, {0.1, 4}});
  levels["levels"][1]["status"] = "unstable: inverted at 0.003 s";
  levels["levels"][1]["relative_l2"] = nullptr;
  given.add("five-plate-x", levels);
  const Outcome plate = outcome_of(given.results, by_id(t.problems, "plate"), by_id(t.schemes, "x"));
  EXPECT_EQ(plate.why, "unstable: inverted at 0.003 s with d = 0.1 m");
  EXPECT_FALSE(plate.finest().has_value());
  // the place in a file is left out
  given.refuse("five-bar-x-printed-1", "bar.toml:18: material.model: it has no bars. Use another.");
  EXPECT_EQ(outcome_of(given.results, by_id(t.problems, "bar"), by_id(t.schemes, "x-printed")).why,
            "it has no bars. Use another.");
  // a call that fails in words that the table does not know is no refusal
  given.refuse("five-bar-x-printed-1", "out of memory");
  EXPECT_THROW(outcome_of(given.results, by_id(t.problems, "bar"), by_id(t.schemes, "x-printed")),
               MissingResult);
  given.refuse("five-plate-element", "has no bars");
  EXPECT_THROW(outcome_of(given.results, by_id(t.problems, "plate"), by_id(t.schemes, "element")),
               MissingResult);
}

}  // namespace
