#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "reports/assets.hpp"
#include "reports/checks.hpp"
#include "reports/comparison/tables.hpp"
#include "reports/scheme_look.hpp"

namespace plumb::reports::sections::five_schemes {
namespace {

using namespace comparison;
using comparison::Problem;  // not the problem of another page

const std::string source = "verification/comparison/five_schemes.toml";

Table table_of(Extent extent) {
  return read_table(std::string(assets::five_schemes_toml), source, extent);
}

/// Error over run time, a line per scheme that has an error; nothing, if none has.
std::optional<Figure> cost_figure(const Table& table, const Outcomes& outcomes, const Problem& problem) {
  Figure figure{"five-cost-" + problem.id,
                {problem.title + ": error against run time",
                 {"CPU time", "s", Scale::log},
                 {"relative error", "", Scale::log}},
                fmt::format("The {}, from {:.3g} to {:.3g} m. Below and left is better. Dashed: as printed.",
                            problem.quantity.in_words, problem.spacings.front(), problem.spacings.back()),
                {}};
  figure.picture.labels = Labels::legend;
  figure.picture.height = 480;
  for (const auto& scheme : table.schemes) {
    Series series{scheme.name, {}, {}};
    for (const auto& level : outcomes.at({problem.id, scheme.id}).levels)
      if (level.error && level.cpu_s && *level.error > 0)
        series.x.push_back(*level.cpu_s), series.y.push_back(*level.error);
    for (const auto& job : jobs_of(problem, scheme)) figure.jobs.push_back(job.id);
    if (!series.x.empty()) figure.picture.series.push_back(look_of(series, scheme.paper, scheme.printed));
  }
  if (figure.picture.series.empty()) return std::nullopt;
  return figure;
}

/// The schemes that ran, broke and refused where the table says so, and no others.
Check state_check(const Table& table, const Outcomes& outcomes, const Problem& problem) {
  std::vector<std::string> others;
  for (const auto& scheme : table.schemes) {
    const Cell cell = problem.cell(scheme.id);
    const State declared = !cell.refuses.empty() ? State::refused
                           : cell.breaks         ? State::unstable
                                                 : State::ran;
    const Outcome& outcome = outcomes.at({problem.id, scheme.id});
    if (outcome.state != declared) others.push_back(scheme.name + ": " + state_of(outcome));
  }
  return {problem.title + ": what runs, breaks and is refused",
          "as " + source + " declares",
          others.empty() ? "the same" : fmt::format("{}", fmt::join(others, "; ")),
          pass_if(others.empty()),
          {},
          CheckKind::book_keeping};
}

std::vector<Check> checks_of(const Table& table, const Outcomes& outcomes) {
  std::vector<Check> checks;
  for (const auto& problem : table.problems) {
    checks.push_back(state_check(table, outcomes, problem));
    for (const auto& scheme : table.schemes)
      if (const auto bound = problem.cell(scheme.id).within) {
        const auto finest = outcomes.at({problem.id, scheme.id}).finest();
        checks.push_back(bound_check(problem.title + ": " + scheme.name, finest ? *finest->error : NAN,
                                     *bound, "relative error; truth: " + problem.quantity.source));
      }
  }
  return checks;
}

Section write(const Results& results, Extent extent) {
  const Table table = table_of(extent);
  const Outcomes outcomes = outcomes_of(results, table);
  Section s;
  s.question = "Which of the five schemes should I take?";
  const auto [best, count] = most_taken(table, outcomes);
  s.answer =
      count == 0
          ? "No particle scheme reaches the errors that are asked for."
          : fmt::format(
                "On {} of {} problems \"{}\" needs the least run time among the particle schemes for the "
                "same error.",
                count, table.problems.size(), best);
  s.checks = checks_of(table, outcomes);
  for (const auto& problem : table.problems)
    if (auto figure = cost_figure(table, outcomes, problem)) s.figures.push_back(std::move(*figure));
  s.tables = {advice_table("five-which", "Which scheme should I take", advice_by_problem(table, outcomes)),
              advice_table("five-over-all", "What holds over the problems", advice_over_all(table, outcomes)),
              overview(table, outcomes, false),
              overview(table, outcomes, true),
              numbers(table, outcomes),
              energies(table, outcomes),
              public_numbers(table),
              truths(table)};
  if (table.ladder) s.tables.push_back(largest_steps(results, table));
  s.tables_above = 4;  // what to take, and the two overviews
  s.notes = {
      "000, mended, is what a scene without a [method] gets. A scheme is its defaults (mended) or the keys that its paper prints; what was added on one problem stands "
      "in the note of its row or in the command.",
      "Papers 001 and 002 follow stress by rates with one bulk and one shear modulus. They agree with the law of "
      "the other schemes for small strains only: at large strain a part of their distance is the law.",
      "Elements and particles have the same nodes. CPU time is that of the steps, without set-up."};
  return s;
}

}  // namespace

/// The schemes of five papers side by side, printed and mended, with finite elements as the reference.
SectionPlan planned(Extent extent) {
  return {410, "five-schemes", "Five schemes side by side", jobs_of(table_of(extent)),
          [extent](const Results& results) { return write(results, extent); }};
}

}  // namespace plumb::reports::sections::five_schemes
