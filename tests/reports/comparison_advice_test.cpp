// The schemes side by side: which one is taken, with its numbers, and what the section of the report shows.
#include <gtest/gtest.h>

#include <stdexcept>

#include "places.hpp"
#include "reports/assets.hpp"
#include "reports/comparison/steps.hpp"
#include "reports/named.hpp"
#include "reports/scheme_look.hpp"
#include "tests/reports/comparison_given.hpp"

namespace plumb::reports::sections {
namespace five_schemes {
SectionPlan planned(Extent extent);
}
}  // namespace plumb::reports::sections

namespace {

using namespace plumb::side_by_side_tests;

const Advice& about(const std::vector<Advice>& all, const std::string& words) {
  for (const auto& one : all)
    if (one.question.find(words) != std::string::npos) return one;
  throw std::runtime_error("no advice about " + words);
}

TEST(ComparisonAdvice, EverySentenceHasItsNumber) {
  Given given;
  fill(given);
  const Table t = table();
  const Outcomes outcomes = outcomes_of(given.results, t);
  const auto problems = advice_by_problem(t, outcomes), all = advice_over_all(t, outcomes);
  const Advice& plate = about(problems, "Plate: a plate?");
  EXPECT_EQ(plate.take, "x, mended");  // elements are cheaper, and no particles
  EXPECT_EQ(plate.because, "An error of 20 % takes 2 s of CPU time; finite elements take at most 0.5 s.");
  const Advice& momenta = about(all, "angular momentum (Bar)");
  EXPECT_EQ(momenta.take, "elements");
  EXPECT_EQ(momenta.because, "Relative change of those: elements (1e-15). The others: x, mended (1e-05).");
  const Advice& energy = about(all, "accounts for its energy");
  EXPECT_EQ(energy.take, "none");
  EXPECT_NE(energy.because.find("x, mended (5 %)"), std::string::npos) << energy.because;
  const Advice& harder = about(all, "Which bears a bar?");
  EXPECT_EQ(harder.take, "x, mended; elements");
  EXPECT_NE(harder.because.find("elements (0 %); x, mended (5 %)"), std::string::npos) << harder.because;
  EXPECT_NE(harder.because.find("over that of \"Plate\": elements (0); x, mended (0.5)"), std::string::npos)
      << harder.because;
  const Advice& mending = about(all, "Paper 003");
  EXPECT_EQ(mending.take, "x, mended");
  EXPECT_NE(mending.because.find("on 1 of 1 problems that both ran; the printed error is 4 times"),
            std::string::npos)
      << mending.because;
  EXPECT_NE(mending.because.find("1 more ran mended only"), std::string::npos) << mending.because;
  EXPECT_EQ(most_taken(t, outcomes), (std::pair<std::string, std::size_t>("x, mended", 2)));
}

/// The quicker one is taken, the next one named; what broke, or solves another law, is not taken.
TEST(ComparisonAdvice, OnlyWhatIsSoundIsTaken) {
  Given given;
  fill(given);
  const Table t = table();
  Outcomes outcomes = outcomes_of(given.results, t);
  const Problem plate = by_id(t.problems, "plate");
  outcomes[{"plate", "x-printed"}] = with({{0.4, 0.5}, {0.1, 2}});
  EXPECT_EQ(advice_for(t, outcomes, plate).take, "x, printed");
  EXPECT_NE(advice_for(t, outcomes, plate).because.find("takes 1 s of CPU time; next is x, mended with 2 s"),
            std::string::npos);
  Outcomes broken = outcomes;
  broken[{"plate", "x-printed"}].state = State::unstable;
  EXPECT_EQ(advice_for(t, broken, plate).take, "x, mended");
  outcomes[{"plate", "x-printed"}].other_law = true;
  EXPECT_EQ(advice_for(t, outcomes, plate).take, "x, mended");
  EXPECT_THROW(about(advice_over_all(t, outcomes), "Paper 003"), std::runtime_error);  // nor compared with
  outcomes[{"plate", "x"}] = with({{0.9, 1}, {0.3, 4}});
  const Advice none = advice_for(t, outcomes, plate);
  EXPECT_EQ(none.take, "none");
  EXPECT_EQ(none.because,
            "None has an error of 20 % at these spacings. x, mended comes closest: 30 % in 4 s.");
}

/// The step before the first CFL number that breaks, or with which the energy changes too much.
TEST(ComparisonAdvice, TheLargestStableStep) {
  const Table t = read_table(schemes + R"(
[ladder]
scene = "spin.toml"
set = ["body.spacing=0.1"]
cfl = [0.5, 1, 2]
wave_time = 0.5
energy_within = 0.2
[[ladder.cell]]
schemes = ["x-printed"]
cannot = "it has no step"
[[ladder.cell]]
schemes = ["x"]
set = ["mixed.upwind=none"]
)",
                             "table.toml", Extent::full);
  const StepLadder& ladder = *t.ladder;
  const Scheme x = by_id(t.schemes, "x"), element = by_id(t.schemes, "element");
  ASSERT_EQ(jobs_of(t).size(), 6u);
  EXPECT_EQ(jobs_of(ladder, x)[1].arguments,
            (std::vector<std::string>{"run", "spin.toml", "--set", "body.spacing=0.1", "--set",
                                      "method.scheme=mixed", "--set", "mixed.upwind=none", "--set",
                                      "method.cfl=1", "--out", "{out}"}));
  Given given;
  const auto rung = [&](const std::string& id, double dt, double change, const Json& failure) {
    Json result = run(1, 1, 1);
    result["dt"] = {{"first", dt}};
    result["energy"]["relative_change"] = change;
    result["failure"] = failure;
    given.add(id, result);
  };
  const Json broken{{"cause", "inverted"}, {"time", 0.125}};
  rung("five-step-x-1", 0.1, 0.1, nullptr);
  rung("five-step-x-2", 0.2, 0.1, broken);
  rung("five-step-x-3", 0.4, 0.1, nullptr);  // by chance: a smaller one broke
  const LargestStep found = largest_step(given.results, ladder, x);
  EXPECT_EQ(found.cfl, 0.5);
  EXPECT_EQ(found.step, 0.1);
  EXPECT_FALSE(found.at_least);
  EXPECT_EQ(found.next, "1: inverted at 0.125 s");
  rung("five-step-x-2", 0.2, -0.3, nullptr);
  EXPECT_EQ(largest_step(given.results, ladder, x).next, "1: its energy changes by -30 %");
  rung("five-step-x-2", 0.2, -0.1, nullptr);
  EXPECT_TRUE(largest_step(given.results, ladder, x).at_least);
  EXPECT_EQ(largest_step(given.results, ladder, x).cfl, 2);
  EXPECT_EQ(largest_step(given.results, ladder, by_id(t.schemes, "x-printed")).next, "it has no step");
  EXPECT_FALSE(largest_step(given.results, ladder, by_id(t.schemes, "x-printed")).cfl.has_value());
  EXPECT_THROW(largest_step(given.results, ladder, element), MissingResult);
}

/// A scheme has one colour and one point shape; as printed it is dashed and hollow.
TEST(ComparisonAdvice, OneLookForAScheme) {
  for (std::size_t n = 0; n < 5; ++n) {
    const std::string paper = "00" + std::to_string(n);
    EXPECT_EQ(look_of({"a", {}, {}}, paper, false).colour, n);
    EXPECT_FALSE(look_of({"a", {}, {}}, paper, false).dashed);
    EXPECT_TRUE(look_of({"a", {}, {}}, paper, true).hollow);
    EXPECT_TRUE(look_of({"a", {}, {}}, paper, true).dashed);
  }
  EXPECT_EQ(look_of({"a", {}, {}}, "elements", false).colour, 6u);
}

/// The table of the tree: every problem's file is there, and no cell of the section's tables is empty.
TEST(ComparisonAdvice, TheSectionLeavesNoCellEmpty) {
  const Table longer =
      read_table(std::string(assets::five_schemes_toml), "five_schemes.toml", Extent::long_run);
  for (const auto& problem : longer.problems)
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(PLUMBLINE_SOURCE_DIR) / problem.file))
        << problem.file;
  const Table now = read_table(std::string(assets::five_schemes_toml), "five_schemes.toml", Extent::full);
  EXPECT_EQ(now.schemes.size(), 11u);  // five papers printed and mended, and finite elements
  Given given;
  invent(now, given);
  const auto section = sections::five_schemes::planned(Extent::full).write(given.results);
  for (const auto& shown : section.tables) {
    EXPECT_FALSE(shown.rows.empty()) << shown.id;
    for (const auto& row : shown.rows) {
      EXPECT_EQ(row.size(), shown.columns.size()) << shown.id;
      for (const auto& entry : row) {
        const auto* text = std::get_if<std::string>(&entry);
        EXPECT_TRUE(std::holds_alternative<double>(entry) || (text && !text->empty())) << shown.id;
      }
    }
  }
  const auto& overview = named(section.tables, "five-printed", &DataTable::id);
  EXPECT_EQ(std::get<std::string>(cell_of(overview, overview.rows[0], "004, printed")),
            "refused: a scheme does not follow a motion in time");
  EXPECT_EQ(std::get<std::string>(cell_of(overview, overview.rows[0], "003, printed")), "0.01 % in 8 s");
  EXPECT_EQ(section.figures.size(), now.problems.size());
  for (const auto& figure : section.figures)
    for (const auto& series : figure.picture.series) {
      const Scheme scheme = named(now.schemes, series.label, &Scheme::name);
      EXPECT_EQ(series.colour, look_of({"", {}, {}}, scheme.paper, scheme.printed).colour) << series.label;
      EXPECT_EQ(series.hollow, scheme.printed) << series.label;
    }
  for (const auto& check : section.checks)
    EXPECT_TRUE(check.kind != CheckKind::book_keeping || check.verdict == "pass")
        << check.what << check.measured;
}

/// What runs although the table says that it is refused or breaks, and what breaks although it does not say
/// so, turns the check of its problem red.
TEST(ComparisonAdvice, WhatIsNotDeclaredFails) {
  const Table now = read_table(std::string(assets::five_schemes_toml), "five_schemes.toml", Extent::full);
  Given given;
  invent(now, given);
  given.add("five-plate-004-printed", study({{0.4, 1}, {0.1, 2}}));
  given.add("five-twist-000-printed-1", run(1, 1, 2),
            "time [s],tip displacement x [m],tip displacement z [m]\n0,0,0\n");
  given.add("five-twist-000-printed-2", run(1, 1, 2),
            "time [s],tip displacement x [m],tip displacement z [m]\n0,0,0\n");
  given.add("five-twist-000-printed-3", run(1, 1, 2),
            "time [s],tip displacement x [m],tip displacement z [m]\n0,0,0\n");
  Json broken = run(1, 1, 2);
  broken["status"] = "unstable";
  broken["failure"] = {{"cause", "inverted"}, {"time", 0.125}};
  given.add("five-bending-003-mended-3", broken);
  const auto section = sections::five_schemes::planned(Extent::full).write(given.results);
  std::vector<std::string> red;
  for (const auto& check : section.checks)
    if (check.kind == CheckKind::book_keeping && check.verdict == "fail") red.push_back(check.measured);
  EXPECT_EQ(red, (std::vector<std::string>{"004, printed: ran",
                                           "003, mended: unstable: inverted at 0.125 s with d = 0.25 m",
                                           "000, printed: ran"}));
}

}  // namespace
