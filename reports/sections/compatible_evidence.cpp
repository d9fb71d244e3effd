#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/evidence.hpp"
#include "reports/results.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::compatible_evidence {
namespace {

using Json = nlohmann::ordered_json;

/// One row of the table: a solution on a cloud by a scheme.
struct Row {
  const Problem& problem;
  const Choice& cloud;
  const Choice& scheme;

  std::string id() const { return evidence_job(problem, cloud, scheme).id; }
  std::string name() const { return fmt::format("{}, {}: {}", problem.name, cloud.name, scheme.name); }
  bool projected() const { return scheme.id == "compatible"; }
  bool claimed() const {
    const auto& all = problem.second_order;
    return std::find(all.begin(), all.end(), cloud.id) != all.end();
  }
};

std::vector<Row> rows(const std::vector<Problem>& all) {
  std::vector<Row> found;
  for (const auto& problem : all)
    for (const auto& cloud : problem.clouds)
      for (const auto& scheme : schemes()) found.push_back({problem, cloud_of(cloud), scheme});
  return found;
}

DataTable empty_table() {
  return {"compatible-evidence",
          "Orders of every manufactured solution, by cloud and scheme",
          {{"solution"},
           {"cloud"},
           {"scheme"},
           {"levels", "", 0},
           {"finest d", "m", 3},
           {"relative L₂ error there", "", 3},
           {"order in L₂", "", 3},
           {"from", "", 3},
           {"to", "", 3},
           {"from level to level"},
           {"verdict for order 2"},
           {"order in H₁", "", 3},
           {"from", "", 3},
           {"to", "", 3},
           {"trend"},
           {"CPU time", "s", 3}},
          {}};
}

Entry entry_of(const Json& value) {
  return value.is_number() ? Entry(value.get<double>()) : Entry("-");
}

/// A number that has different names in dynamic and in static studies.
const Json& either(const Json& level, const char* name, const char* other) {
  return level.contains(name) ? level.at(name) : level.at(other);
}

/// Set-up and steps or solution of all levels [s].
double cpu_time(const Json& result) {
  double sum = 0;
  for (const auto& level : result.at("levels"))
    sum += number(level, "setup_s") + either(level, "cpu_s", "solve_s").get<double>();
  return sum;
}

std::string pairs_of(const Json& fit) {
  std::string pairs;
  for (const auto& pair : fit.at("pairwise"))
    pairs += (pairs.empty() ? "" : ", ") +
             (pair.is_null() ? std::string("-") : fmt::format("{:.2f}", pair.get<double>()));
  return pairs;
}

std::vector<Entry> entries_of(const Row& row, const Json& result) {
  const Json &l2 = fit_of(result, "l2"), &h1 = fit_of(result, "h1"), &finest = result.at("levels").back();
  const Json& error = finest.at("relative_l2");
  return {row.problem.name,
          row.cloud.name,
          row.scheme.name,
          static_cast<double>(result.at("levels").size()),
          number(finest, "d"),
          error.is_null() ? Entry("run breaks") : entry_of(error),
          entry_of(l2.at("order")),
          entry_of(l2.at("ci95").at(0)),
          entry_of(l2.at("ci95").at(1)),
          pairs_of(l2),
          text(l2, "verdict"),
          entry_of(h1.at("order")),
          entry_of(h1.at("ci95").at(0)),
          entry_of(h1.at("ci95").at(1)),
          text(h1, "verdict"),
          cpu_time(result)};
}

/// A combination that cannot be built is a row that says why.
std::vector<Entry> refused_entries(const Row& row, const std::string& failure) {
  std::vector<Entry> entries{row.problem.name, row.cloud.name, row.scheme.name};
  entries.resize(empty_table().columns.size());
  entries[5] = "refused: " + failure;
  return entries;
}

/// Order 1 or better, up to what the verdicts resolve (lib/convergence/README.md); fails where none is
/// fitted.
Check gradient_check(const Row& row, const Json& result) {
  constexpr double resolution = 0.1;
  Check check = study_check(row.name() + ", H₁", result, "h1");
  const Json& order = fit_of(result, "h1").at("order");
  check.expected = fmt::format("order 1 or better, to {:g}", resolution);
  check.verdict = pass_if(order.is_number() && order.get<double>() >= 1 - resolution);
  check.job = row.id();
  return check;
}

/// Every study of compatible bonds on irregular particles is a check of order 2, and where order 2 is claimed
/// the gradient is one too. That another scheme lacks order 2 is a check only where its interval excludes it.
/// Nothing is demanded of the others on lattices.
void add_checks(std::vector<Check>& checks, const Row& row, const Json& result) {
  const std::string name = row.name() + ", L₂";
  if (row.projected() && (row.claimed() || !is_lattice(row.cloud))) {
    checks.push_back(study_check(name, result, "l2"));
    checks.back().job = row.id();
    if (row.claimed()) checks.push_back(gradient_check(row, result));
  } else if (!row.projected() && row.claimed() && !is_lattice(row.cloud)) {
    if (auto check = exclusion_check(name, result, "l2", 2)) {
      check->job = row.id();
      checks.push_back(*check);
    }
  }
}

/// What was counted over the studies on irregular clouds.
struct Count {
  int compatible = 0, passed = 0;                   ///< studies of compatible bonds
  int others = 0, others_passed = 0, excluded = 0;  ///< of the two other schemes
};

void add_to(Count& count, const Row& row, const Json* result) {
  if (is_lattice(row.cloud)) return;
  ++(row.projected() ? count.compatible : count.others);
  if (!result) return;
  if (text(fit_of(*result, "l2"), "verdict") == "pass")
    ++(row.projected() ? count.passed : count.others_passed);
  if (!row.projected() && exclusion_check("", *result, "l2", 2)) ++count.excluded;
}

Section write(const Results& results, const std::vector<Problem>& all) {
  Section s;
  s.question = "Which scheme keeps order 2 when particles are not a lattice?";
  DataTable table = empty_table();
  Count count;
  for (const auto& row : rows(all)) {
    const std::string& failure = results.job(row.id()).failure;
    table.jobs.push_back(row.id());
    if (!failure.empty()) {
      add_to(count, row, nullptr);
      table.rows.push_back(refused_entries(row, failure));
      if (row.claimed() && row.projected())
        s.checks.push_back({row.name(), "order 2", failure, "not-computed", row.id()});
      continue;
    }
    const Json result = results.json(row.id());
    table.rows.push_back(entries_of(row, result));
    add_to(count, row, &result);
    add_checks(s.checks, row, result);
  }
  s.tables = {table};
  s.answer = fmt::format(
      "On clouds that are no lattice compatible bonds pass with order 2 in {} of {} "
      "studies. The two schemes that are not projected pass in {} of {}; in {} of "
      "these their interval excludes order 2, in the others it does not or a run breaks.",
      count.passed, count.compatible, count.others_passed, count.others, count.excluded);
  s.notes = {
      "All three run on the same particles and with the same boundary values. Static plates have exact "
      "displacements on the edge and no time, so JST and the integrator do not enter; all others have the "
      "finite-strain body force, but for the linear plate. What does not pass is listed with its verdict.",
      "Each study of compatible bonds on irregular particles is a check of order 2. "
      "That another scheme lacks it is a check only where the interval excludes order "
      "2 (its upper end is below 1.9): any other verdict says nothing about that.",
      "Vortices have free circles. Where particles lie on them (layout node) order 2 is claimed; "
      "at an amplitude of 0.5 rad irregular particles need the hourglass energy, THEORY (12.1). "
      "On clipped rings (long report) no particle lies on the circles, facets are extrapolated "
      "from the particles nearby, and nothing is claimed (THEORY chapter 11)."};
  return s;
}

}  // namespace

/// Compatible bonds beside the other schemes on every manufactured solution.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const auto all = problems(long_run);
  SectionPlan plan{340,
                   "compatible-evidence",
                   "Compatible bonds: all manufactured solutions",
                   {},
                   [all](const Results& results) { return write(results, all); }};
  for (const auto& row : rows(all)) plan.jobs.push_back(evidence_job(row.problem, row.cloud, row.scheme));
  plan.least = Extent::full;
  return plan;
}

}  // namespace plumb::reports::sections::compatible_evidence
