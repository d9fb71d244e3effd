#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "plumb/commands.hpp"
#include "plumb/extrapolation_output.hpp"
#include "plumb/fit_text.hpp"
#include "plumb/level_table.hpp"
#include "plumb/session.hpp"
#include "plumbline/convergence/outcome.hpp"
#include "plumbline/convergence/verdict.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/input/document.hpp"
#include "reports/picture.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct JudgeOptions {
  std::string table, spacing, limit;
  std::vector<std::string> errors;
  std::vector<double> expect;
  double safety = 1.25;
};

/// One column of errors with its levels and its fit.
struct Column {
  std::string name;
  std::vector<RunsOfLevel> runs;
  OrderFit fit;
  std::optional<double> declared;
  std::string verdict;
};

/// The named columns; without names all but the spacing.
std::vector<std::size_t> value_columns(const NumberTable& table, std::size_t spacing,
                                       const JudgeOptions& options) {
  std::vector<std::size_t> columns;
  for (const auto& name : options.errors) columns.push_back(table.column(name));
  for (std::size_t k = 0; options.errors.empty() && k < table.names.size(); ++k)
    if (k != spacing) columns.push_back(k);
  if (columns.empty())
    throw InputError(options.table + " has one column", "beside the spacing an error is needed",
                     "Give a table with two columns or more.");
  return columns;
}

Column column_of(const NumberTable& table, std::size_t spacing, std::size_t at,
                 std::optional<double> declared) {
  Column column{table.names[at], runs_of(table, spacing, at), {}, declared, {}};
  std::vector<Level> levels;
  for (const RunsOfLevel& run : column.runs) levels.push_back({run.spacing, run.typical()});
  FitOptions options;
  options.round_off = 0;  // the unit of the errors is not known, so their floor is not either
  column.fit = fit_order(levels, options);
  column.verdict = declared ? name_of(judge(column.fit, *declared)) : name_of(classify(column.fit));
  return column;
}

Json json_of(const Column& column) {
  Json levels = Json::array();
  for (const RunsOfLevel& run : column.runs)
    levels.push_back({{"h", run.spacing},
                      {"error", run.typical()},
                      {"runs", run.values.size()},
                      {"spread", run.spread() ? Json(*run.spread()) : Json()}});
  return {{"norm", column.name},
          {"order", column.fit.order},
          {"ci95", {column.fit.lower, column.fit.upper}},
          {"pairwise", column.fit.pairwise},
          {"drift", column.fit.drift},
          {"levels", column.fit.levels.size()},
          {"declared", column.declared ? Json(*column.declared) : Json()},
          {"verdict", column.verdict},
          {"rows", levels}};
}

reports::Picture picture_of(const JudgeOptions& options, const std::vector<Column>& columns) {
  reports::Picture picture;
  picture.title = options.table;
  picture.x = {"spacing", "", reports::Scale::log};
  picture.y = {"error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const Column& column : columns) {
    reports::Series series;
    series.label = column.name;
    for (const RunsOfLevel& run : column.runs)
      series.x.push_back(run.spacing), series.y.push_back(std::abs(run.typical()));
    if (column.declared && picture.triangles.empty())
      picture.triangles.push_back({*column.declared, picture.series.size()});
    picture.series.push_back(series);
  }
  return picture;
}

int judge_errors(const Session& session, const JudgeOptions& options, const NumberTable& table,
                 std::size_t spacing) {
  const auto places = value_columns(table, spacing, options);
  if (options.expect.size() > 1 && options.expect.size() != places.size())
    throw InputError(
        fmt::format("{} declared orders for {} columns of errors", options.expect.size(), places.size()),
        "each column has one", "Give one order for all of them, or one for each.");
  std::vector<Column> columns;
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::optional<double> declared;
    if (!options.expect.empty()) declared = options.expect[options.expect.size() == 1 ? 0 : k];
    columns.push_back(column_of(table, spacing, places[k], declared));
  }
  std::vector<FitLine> lines;
  std::vector<Judged> judged;
  Json fits = Json::array();
  for (const Column& column : columns) {
    lines.push_back({column.name, column.fit, column.declared, column.verdict});
    judged.push_back({column.verdict, column.declared.has_value()});
    fits.push_back(json_of(column));
    for (const RunsOfLevel& run : column.runs)
      if (const auto spread = run.spread())
        session.text() << fmt::format("{}, h = {:g}: {:.4g} from {} runs, spread {:.2g} of it\n", column.name,
                                      run.spacing, run.typical(), run.values.size(), *spread);
  }
  const std::string_view status = status_of(judged);
  session.text() << fits_text(lines) << "status: " << status << '\n';
  session.write_json({{"table", options.table}, {"fits", fits}, {"status", status}});
  if (!session.plot.empty())
    for (const auto& dropped : reports::save(picture_of(options, columns), session.plot))
      session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
  return exit_code_of(status);
}

/// Values without an exact one: means over the runs of each level are extrapolated.
int find_limit(const Session& session, const JudgeOptions& options, const NumberTable& table,
               std::size_t spacing) {
  if (options.limit != "unknown")
    throw InputError(fmt::format("--limit {}", options.limit), "a known limit makes errors of the values",
                     "Write --limit unknown, or give the errors.");
  const auto places = value_columns(table, spacing, options);
  if (places.size() > 1)
    throw InputError(fmt::format("{} columns of values", places.size()), "one is extrapolated at a time",
                     "Choose one with --error NAME.");
  if (options.expect.size() > 1) throw InputError("several declared orders for one column", "", "Give one.");
  std::vector<Sample> samples;
  for (const RunsOfLevel& run : runs_of(table, spacing, places.front()))
    samples.push_back({run.spacing, run.mean()});
  const Extrapolated found = extrapolated(
      samples, options.safety, options.expect.empty() ? std::nullopt : std::optional(options.expect.front()));
  session.text() << table.names[places.front()] << '\n' << found.text;
  Json result{{"table", options.table}, {"column", table.names[places.front()]}};
  result.update(found.json);
  session.write_json(result);
  return exit_code_of(found.status);
}

int judge_action(const Session& session, const JudgeOptions& options) {
  const NumberTable table = parse_numbers(read_text(options.table), options.table);
  const std::size_t spacing = options.spacing.empty() ? 0 : table.column(options.spacing);
  return options.limit.empty() ? judge_errors(session, options, table, spacing)
                               : find_limit(session, options, table, spacing);
}

}  // namespace

/// `plumb judge`: anybody's table of errors or values.
void add_judge(CLI::App& program, Session& session) {
  const auto options = std::make_shared<JudgeOptions>();
  CLI::App& command =
      add_command(program, session,
                  {"judge", "orders, intervals and verdicts of a table of errors that another program made",
                   "plumb judge verification/studies/errors.csv --error l2 --expect 0.5"},
                  {.plot = true}, [&session, options] { return judge_action(session, *options); });
  command
      .add_option(
          "table", options->table,
          "one row per run: numbers separated by commas, semicolons (then decimal commas are read), tabs or "
          "blanks, with a heading or without; rows of the same spacing are runs of one level")
      ->type_name("TABLE.csv")
      ->required();
  command.add_option("--h", options->spacing, "column of the spacing (default: the first)")
      ->type_name("NAME");
  command
      .add_option(
          "--error", options->errors,
          "columns of the errors, or of the values (default: all others); without a heading columns are "
          "called 1, 2, ..")
      ->type_name("NAME,NAME,..")
      ->delimiter(',');
  command.add_option("--expect", options->expect, "declared order, one for all columns or one for each")
      ->type_name("ORDER,..")
      ->delimiter(',');
  command
      .add_option(
          "--limit", options->limit,
          "unknown: the column holds values, not errors; they are extrapolated, with their uncertainty")
      ->type_name("unknown");
  command
      .add_option("--safety", options->safety, "safety factor of the index (Roache: 1.25 from three grids)")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  point_to_verdicts(command);
}

}  // namespace plumb
