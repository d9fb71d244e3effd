#include "reports/comparison/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "reports/comparison/steps.hpp"

namespace plumb::reports::comparison {
namespace {

Entry entry(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Entry(*value) : Entry("not known");
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

}  // namespace

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

DataTable largest_steps(const Results& results, const Table& table) {
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

DataTable public_numbers(const Table& table) {
  DataTable out{"five-public",
                "Numbers of papers and other codes for these problems, as such",
                {{"problem"}, {"code"}, {"value", "SI", 4}, {"truth", "SI", 4}, {"error", "", 3}, {"note"}},
                {}};
  for (const auto& problem : table.problems)
    for (const auto& other : problem.others) {
      const double truth = problem.quantity.truth.at(0);
      out.rows.push_back({problem.title, other.code, other.value, truth,
                          std::abs(other.value - truth) / problem.quantity.scale, other.note});
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

}  // namespace plumb::reports::comparison
