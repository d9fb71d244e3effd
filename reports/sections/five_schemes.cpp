#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "reports/assets.hpp"
#include "reports/checks.hpp"
#include "reports/comparison/advice.hpp"
#include "reports/comparison/steps.hpp"
#include "reports/scheme_look.hpp"

namespace plumb::reports::sections {
namespace {

using namespace comparison;

const std::string source = "verification/comparison/five_schemes.toml";

Table table_of(bool long_run) {
  return read_table(std::string(assets::five_schemes_toml), source, long_run);
}

Entry entry(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Entry(*value) : Entry("not known");
}

std::string state_of(const Outcome& outcome) {
  switch (outcome.state) {
    case State::refused:
      return "refused: " + outcome.why;
    case State::unstable:
      return outcome.why;
    default:
      return "ran";
  }
}

/// "0.34 % in 0.2 s", or why there is no error.
std::string cell_text(const Outcome& outcome) {
  const auto finest = outcome.finest();
  if (!finest) {
    const std::string all = state_of(outcome);
    return all.substr(0, all.find(". "));  // the whole of it stands in the table of numbers
  }
  std::string text = fmt::format("{} in {:.2g} s", percent(*finest->error), finest->cpu_s.value_or(0));
  if (outcome.state == State::unstable) text += "; " + outcome.why;
  return text;
}

/// Problems over schemes, those as printed or the others; finite elements stand in both.
DataTable overview(const Table& table, const Outcomes& outcomes, bool printed) {
  DataTable out{printed ? "five-printed" : "five-mended",
                fmt::format("Error at the finest spacing and CPU time of its steps, schemes {}",
                            printed ? "as printed" : "mended"),
                {{"problem"}, {"spacing", "m", 3}},
                {}};
  const auto shown = [&](const Scheme& scheme) {
    return scheme.printed == printed || scheme.paper == "elements";
  };
  for (const auto& scheme : table.schemes)
    if (shown(scheme)) out.columns.push_back({scheme.name});
  for (const auto& problem : table.problems) {
    std::vector<Entry> row{problem.title, problem.spacings.back()};
    for (const auto& scheme : table.schemes)
      if (shown(scheme)) row.emplace_back(cell_text(outcomes.at({problem.id, scheme.id})));
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::string equal_error_text(const Outcome& outcome, double error) {
  const auto cost = cost_at(outcome, error);
  if (!cost) return "not reached";
  return fmt::format("{}{:.3g}", cost->at_most ? "at most " : "", cost->cpu_s);
}

std::string note_of(const Outcome& outcome) {
  const std::string law = "another law at these strains";
  if (!outcome.other_law) return outcome.note.empty() ? "-" : outcome.note;
  return outcome.note.empty() ? law : outcome.note + "; " + law;
}

/// Everything that is known of every cell.
DataTable numbers(const Table& table, const Outcomes& outcomes) {
  DataTable out{"five-numbers",
                "Every scheme on every problem, at the finest spacing",
                {{"problem"},
                 {"scheme"},
                 {"what became of it"},
                 {"error", "", 3},
                 {"order", "", 3},
                 {"95 % from", "", 3},
                 {"to", "", 3},
                 {"CPU time", "s", 3},
                 {"CPU time at equal error", "s"},
                 {"equal error", "", 2},
                 {"steps", "", 0},
                 {"memory per particle", "bytes", 3},
                 {"largest memory", "MB", 3},
                 {"drift of linear momentum", "", 2},
                 {"drift of angular momentum", "", 2},
                 {"note"}},
                {}};
  for (const auto& problem : table.problems)
    for (const auto& scheme : table.schemes) {
      const Outcome& o = outcomes.at({problem.id, scheme.id});
      const auto finest = o.finest();
      const Entry not_free("supports act");
      std::optional<double> megabytes;
      if (o.peak_rss) megabytes = 1e-6 * *o.peak_rss;
      out.rows.push_back(
          {problem.title, scheme.name, state_of(o), entry(finest ? finest->error : std::nullopt),
           entry(o.fit.order), entry(o.fit.lower), entry(o.fit.upper),
           entry(finest ? finest->cpu_s : std::nullopt), equal_error_text(o, problem.equal_error),
           problem.equal_error, entry(finest ? finest->steps : std::nullopt), entry(o.bytes_per_particle),
           entry(megabytes), problem.free ? entry(o.linear_drift) : not_free,
           problem.free ? entry(o.angular_drift) : not_free, note_of(o)});
      out.row_jobs.push_back(jobs_of(problem, scheme).back().id);
      out.figures.push_back("five-cost-" + problem.id);
    }
  return out;
}

/// Energy by cause, of the cells that have an energy at the start.
DataTable energies(const Table& table, const Outcomes& outcomes) {
  DataTable out{"five-energy",
                "Energy at the end by cause, as shares of the energy at the start",
                {{"problem"},
                 {"scheme"},
                 {"change", "%", 3},
                 {"dissipated by the scheme", "%", 3},
                 {"plastic work", "%", 3},
                 {"hourglass and other terms", "%", 3},
                 {"unexplained", "%", 3}},
                {}};
  for (const auto& problem : table.problems)
    for (const auto& scheme : table.schemes) {
      const auto& energy = outcomes.at({problem.id, scheme.id}).energy;
      if (!energy) continue;
      out.rows.push_back({problem.title, scheme.name, 100 * energy->change,
                          energy->dissipated ? Entry(100 * *energy->dissipated) : Entry("not booked"),
                          100 * energy->plastic, 100 * energy->more, 100 * energy->unexplained});
      out.row_jobs.push_back(jobs_of(problem, scheme).back().id);
    }
  return out;
}

DataTable advice_table(std::string id, std::string title, const std::vector<Advice>& all) {
  DataTable out{std::move(id), std::move(title), {{"question"}, {"take"}, {"because"}}, {}};
  for (const auto& one : all) out.rows.push_back({one.question, one.take, one.because});
  return out;
}

DataTable steps(const Results& results, const Table& table) {
  DataTable out{"five-steps",
                "The largest stable step: free spin, CFL numbers from small to large",
                {{"scheme"},
                 {"largest stable CFL number"},
                 {"its step", "s", 3},
                 {"over the time of a wave between particles", "", 3},
                 {"the next CFL number"}},
                {}};
  for (const auto& scheme : table.schemes) {
    const LargestStep found = largest_step(results, *table.ladder, scheme);
    std::optional<double> share;
    if (found.step) share = *found.step / table.ladder->wave_time;
    out.rows.push_back(
        {scheme.name,
         found.cfl ? fmt::format("{}{:.3g}", found.at_least ? "at least " : "", *found.cfl) : "none",
         entry(found.step), entry(share), found.next});
  }
  return out;
}

DataTable truths(const Table& table) {
  DataTable out{"five-truths",
                "What is compared, and where the truth comes from",
                {{"problem"}, {"compared"}, {"source of the truth"}},
                {}};
  for (const auto& problem : table.problems)
    out.rows.push_back({problem.title, problem.quantity.in_words, problem.quantity.source});
  return out;
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

Section write(const Results& results, bool long_run) {
  const Table table = table_of(long_run);
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
              truths(table)};
  if (table.ladder) s.tables.push_back(steps(results, table));
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
SectionPlan five_schemes(bool long_run) {
  return {410, "five-schemes", "Five schemes side by side", jobs_of(table_of(long_run)),
          [long_run](const Results& results) { return write(results, long_run); }};
}

}  // namespace plumb::reports::sections
