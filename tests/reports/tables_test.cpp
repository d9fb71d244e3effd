// What the tables of the report show: every number is looked up in (invented) results, and must be that of
// its column, of a study that the table names, in the unit of its heading.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "reports/named.hpp"
#include "tests/reports/invented_report.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::InventedReport;
using plumb::test::near;
using plumb::test::Origin;
using plumb::test::Words;

/// Headings that are not the name of their column, and the columns of results that they may show.
const std::multimap<std::string, std::string> headings{
    {"order in L₂", "order"},
    {"order in H₁", "order"},
    {"95 % from", "low"},
    {"from", "low"},
    {"to", "high"},
    {"relative L₂ error", "relative_l2"},
    {"relative L₂ error there", "relative_l2"},
    {"relative H₁ error", "relative_h1"},
    {"relative stress error, L₂", "relative_stress_l2"},
    {"relative velocity l2", "relative_velocity_l2"},
    {"relative stress l2", "relative_stress_l2"},
    {"relative error", "error"},
    {"set-up", "setup_s"},
    {"solution", "solve_s"},
    {"peak memory", "peak_rss"},
    {"spread", "cpu_spread_s"},
    {"CPU time", "cpu_s"},
    {"CPU time", "ns_per_particle"},
    {"CPU time", "cost"},
    {"pair evaluations", "cost"},
    {"lowest not rigid", "lowest_nonrigid"},
    {"per CPU second", "updates_per_cpu_s"},
    {"per second", "updates_per_wall_s"},
    {"updates", "updates_per_cpu_s"},
    {"set-up", "setup_cpu_s"},
    {"set-up", "setup_wall_s"},
    {"arrays", "bytes_per_particle"},
    {"moved", "bytes_per_update"},
    {"share of FMA limit", "fraction_of_fma"},
    {"share of triad limit", "fraction_of_triad"},
    {"share in use", "fraction_of_fma"},
    {"share in use", "fraction_of_triad"},
    {"times as fast", "fma_speed_up"},
    {"times as fast", "triad_speed_up"},
    {"times as fast", "speed_up"},
    {"fused multiply-adds", "fma_gflops"},
    {"triad", "triad_gbs"},
    {"triad against one core", "triad_speed_up"},
    {"change of energy", "relative_change"},
    {"energy change", "relative_change"},
    {"end", "time"},
    {"first step", "first dt"},
    {"least step", "least dt"},
    {"particles", "n"},
    {"found", "updates_per_cpu_s"},
    {"found", "bytes_per_particle"},
    {"found", "setup_cpu_s"},
    {"coarsest", "constraint_inside"},
    {"step", "first dt"},
    {"drift of momentum", "linear drift"},
    {"drift of angular momentum", "angular drift"},
    {"strain energy", "strain"},
    {"finest", "constraint_inside"},
};

/// Entries that are made of several numbers of results; other tests hold them, or those of the pictures.
const std::set<std::pair<std::string, std::string>> computed{
    {"budget", "angular momentum"},
    {"budget", "energy"},
    {"column-work", "error, adjoint reference"},
    {"column-work", "error, reference of the paper's scheme"},
    {"mixed-columns-tension", "error"},  // Drawn.TheErrorsOfTheColumnsOfPaper003AreThoseOfTheirTips
    {"mixed-columns-bending", "error"},
    {"mixed-columns-twist", "error"},
    {"compatible-evidence", "CPU time"},
    {"near-incompressible", "order from d = 0.2 at 0.49995"},
    {"compatible-columns", "length over that at the start"},
    {"work-ratio", "relative error"},  // what was asked for
    {"work-cheapest", "relative error"},
    {"statics", "ours"},  // a displacement or an energy; the others have published numbers
    {"statics", "of others"},
    {"statics", "off by"},
    {"flag", "ours"},  // of the last swing; swing_test has those
    {"flag", "published"},
    {"flag", "off by"},
    {"scaling-runs", "tip"},  // the checks of the section hold it
    {"scaling-growth", "power"},
    {"dynamics-runs", "off the reference"},  // ends of two runs: dynamics_test.cpp
    {"dynamics-orders", "order"},
    {"cantilever-runs", "paper"},  // printed
    {"cantilever-runs", "paper's"},
    {"cantilever-runs", "its paper's"},
    {"cantilever-runs", "off the field's"},  // of the energy beside it: dynamics_test.cpp
    {"cantilever-runs", "off the load's work"},
    {"cantilever-orders", "order"},
};

/// What a number of a result is multiplied by to be shown in this unit.
double scale_of(const std::string& unit) {
  if (unit == "%") return 100;
  if (unit == "µs") return 1e6;
  if (unit == "MB") return 1e-6;
  return unit.starts_with("10⁶") ? 1e-6 : 1;
}

/// Whether a heading may show that column.
bool may_show(const std::string& heading, const std::string& column) {
  std::string plain = heading;
  for (char& c : plain)
    if (c == ' ') c = '_';
  if (heading == column || plain == column || (heading.starts_with("ν = ") && column == "error")) return true;
  const auto [first, last] = headings.equal_range(heading);
  return std::any_of(first, last, [&](const auto& entry) { return entry.second == column; });
}

class Tables : public InventedReport {
 protected:
  /// Where a number comes from, if it is one of the results that the table or the row names.
  const Origin* origin_of(double value, const std::set<std::string>& jobs) const {
    const auto next = invention.origins.lower_bound(value * (1 - 1e-12));
    if (next == invention.origins.end() || !near(next->first, value)) return nullptr;
    return jobs.contains(next->second.row->job) ? &next->second : nullptr;
  }

  /// Speeds and recorded orders of other codes, and speeds of two threads against one: no number of a study.
  static bool is_compared(const DataTable& table, std::size_t row) {
    const auto& what = std::get<std::string>(table.rows[row][0]);
    return (table.id == "peers-speeds" && !what.starts_with("Plumbline")) ||
           (table.id == "foreign-codes-orders" && what != "invented elements") ||
           what.find("against one") != std::string::npos;
  }

  static std::set<std::string> jobs_of(const DataTable& table, std::size_t row) {
    if (!table.row_jobs.empty()) return {table.row_jobs.at(row)};
    if (table.jobs.size() == table.rows.size()) return {table.jobs.at(row)};
    return {table.jobs.begin(), table.jobs.end()};
  }

  /// The studies and rows that the numbers of a row of a table come from, each number checked.
  std::vector<Origin> check_numbers(const DataTable& table, std::size_t row) const {
    std::vector<Origin> origins;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const Column& column = table.columns[k];
      const auto* shown = std::get_if<double>(&table.rows[row][k]);
      if (!shown ||
          (k > 0 && std::holds_alternative<std::string>(table.rows[row][0]) && is_compared(table, row)))
        continue;
      if (computed.contains({table.id, column.name}) || is_given(column.name)) continue;
      const std::string where = table.id + ", \"" + column.name + "\" of row " + std::to_string(row);
      const bool goal = table.id == "speed-goals" && *shown < 1e-5;  // its unit stands in the row
      const Origin* origin = origin_of(*shown / (goal ? 1e-6 : scale_of(column.unit)), jobs_of(table, row));
      if (!origin) {
        ADD_FAILURE() << where << ": " << *shown << " stands in none of its studies";
        continue;
      }
      EXPECT_TRUE(may_show(column.name, origin->column)) << where << " shows " << origin->column;
      origins.push_back(*origin);
    }
    return origins;
  }

  /// What is given with a row and not measured.
  static bool is_given(const std::string& heading) {
    static const std::set<std::string> names{
        "d",           "particles",  "threads",  "dimension", "levels",
        "U",           "neighbours", "declared", "finest d",  "finest pair of levels",
        "cells across"};
    return names.contains(heading);
  }

  /// What is given in a row of a table is given in the row of the result, too.
  void check_given(const DataTable& table, std::size_t row, const std::vector<Origin>& origins) const {
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const std::string& heading = table.columns[k].name;
      const std::string where = table.id + ", \"" + heading + "\" of row " + std::to_string(row);
      for (const Origin& origin : origins) {
        if (const auto* number = std::get_if<double>(&table.rows[row][k])) {
          const auto given = origin.row->numbers.find(heading == "particles" ? "n" : heading);
          if (is_given(heading) && given != origin.row->numbers.end()) {
            EXPECT_EQ(*number, given->second) << where;
          }
        } else if (const auto* text = std::get_if<std::string>(&table.rows[row][k])) {
          bool named = false;  // the heading is the key of the word
          for (const auto& [key, value] : origin.row->words)
            if (key.substr(key.rfind('.') + 1) == heading) {
              EXPECT_EQ(*text, value) << where;
              named = true;
            }
          if (!named) check_claims(*text, facts_of(origin), where);
        }
      }
    }
  }
};

TEST_F(Tables, EveryRowIsWholeAndEveryTableHasRows) {
  for (const auto& [id, section] : sections)
    for (const auto& table : section.tables) {
      EXPECT_FALSE(table.rows.empty()) << table.id;
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.id;
      if (!table.row_jobs.empty()) {
        EXPECT_EQ(table.row_jobs.size(), table.rows.size()) << table.id;
      }
    }
}

/// The picture beside a row is one of the section that shows the study of the row.
TEST_F(Tables, EveryRowHasThePictureOfItsStudy) {
  std::size_t rows = 0;
  for (const auto& [id, section] : sections)
    for (const auto& table : section.tables)
      for (std::size_t row = 0; row < table.figures.size(); ++row) {
        if (table.figures[row].empty()) continue;
        const auto figure = std::find_if(section.figures.begin(), section.figures.end(),
                                         [&](const Figure& f) { return f.id == table.figures[row]; });
        ASSERT_NE(figure, section.figures.end()) << table.id << ": " << table.figures[row];
        const auto& shown = figure->jobs;
        const auto jobs = jobs_of(table, row);
        EXPECT_TRUE(
            std::any_of(shown.begin(), shown.end(), [&](const auto& job) { return jobs.contains(job); }))
            << table.id << ": " << *jobs.begin() << " is not in " << figure->id;
        ++rows;
      }
  EXPECT_GT(rows, 50u);
}

/// What a check of an order measured is the fit of its study in the norm that it names.
TEST_F(Tables, ChecksOfOrdersSayWhatTheirStudiesFound) {
  std::size_t checked = 0;
  for (const auto& [id, section] : sections)
    for (const Check& check : section.checks) {
      const bool l2 = check.what.find("L₂") != std::string::npos,
                 h1 = check.what.find("H₁") != std::string::npos;
      if (check.job.empty() || l2 == h1 || !calls.contains(check.job)) continue;
      const auto result = invention.results.json(check.job);
      if (!result.contains("fits")) continue;
      for (const auto& fit : result.at("fits")) {
        if (!fit.contains("norm") || fit.at("norm") != (l2 ? "l2" : "h1")) continue;
        const std::string text = fmt::format("{:.2f}, 95 % interval [{:.2f}, {:.2f}]", number(fit, "order"),
                                             number(fit, "low"), number(fit, "high"));
        EXPECT_TRUE(check.measured.starts_with(text))
            << id << ", " << check.what << ": " << check.measured << ", not " << text;
        ++checked;
      }
    }
  EXPECT_GT(checked, 40u);
}

/// Every row of fitted orders that declares one is a check of its section.
TEST_F(Tables, EveryDeclaredOrderOfTheSwingingPlateIsChecked) {
  std::set<std::string> fitted, checked;
  for (const std::string& job : by_id(sections.at("plate").tables, "plate-fits").row_jobs) fitted.insert(job);
  for (const Check& check : sections.at("plate").checks) checked.insert(check.job);
  EXPECT_EQ(fitted, checked);
  EXPECT_GT(fitted.size(), 5u);
}

TEST_F(Tables, EveryNumberIsThatOfItsHeadingRowAndStudy) {
  std::size_t numbers = 0;
  for (const auto& [id, section] : sections)
    for (const auto& table : section.tables)
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto origins = check_numbers(table, row);
        check_given(table, row, origins);
        numbers += origins.size();
      }
  EXPECT_GT(numbers, 2000u);
}

}  // namespace
