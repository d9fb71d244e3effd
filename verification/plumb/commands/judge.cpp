#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "lib/input/document.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/extrapolation_output.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/foreign/judge_particles.hpp"
#include "verification/plumb/judged_columns.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct JudgeOptions {
  std::string table, spacing, limit;
  std::vector<std::string> errors;
  std::vector<double> expect;
  double safety = 1.25;
  ParticleOptions particles;
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

int judge_errors(const Session& session, const JudgeOptions& options, const NumberTable& table,
                 std::size_t spacing) {
  const auto places = value_columns(table, spacing, options);
  const auto declared = declared_orders(options.expect, places.size());
  std::vector<JudgedColumn> columns;
  for (std::size_t k = 0; k < places.size(); ++k)
    columns.push_back(judged_column(table.names[places[k]], runs_of(table, spacing, places[k]), declared[k]));
  const std::string status = status_of(columns);
  tell_columns(session, columns);
  session.text() << "status: " << status << '\n';
  session.write_json({{"table", options.table}, {"fits", fits_json(columns)}, {"status", status}});
  draw_columns(session, options.table, columns);
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
  if (options.table.empty() == options.particles.files.empty())
    throw InputError(options.table.empty() ? "nothing to judge" : "a table and --particles",
                     "one of them is judged at a time",
                     "give a table, or --particles FILES --solution NAME --time T");
  if (!options.particles.files.empty())
    return judge_particles(session, options.particles, options.errors, options.expect);
  const NumberTable table = parse_numbers(read_text(options.table), options.table);
  const std::size_t spacing = options.spacing.empty() ? 0 : table.column(options.spacing);
  return options.limit.empty() ? judge_errors(session, options, table, spacing)
                               : find_limit(session, options, table, spacing);
}

}  // namespace

/// `plumb judge`: anybody's table of errors or values, or what another program wrote of its particles.
void add_judge(CLI::App& program, Session& session) {
  const auto options = std::make_shared<JudgeOptions>();
  CLI::App& command = add_command(
      program, session,
      {"judge",
       "orders, intervals and verdicts of what another program made: a table of errors, or its particles",
       "plumb judge verification/studies/errors.csv --error l2 --expect 0.5"},
      {.plot = true}, [&session, options] { return judge_action(session, *options); });
  command
      .add_option(
          "table", options->table,
          "one row per run: numbers separated by commas, semicolons (then decimal commas are read), tabs or "
          "blanks, with a heading or without; rows of the same spacing are runs of one level")
      ->type_name("TABLE.csv");
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
  add_particle_options(command, options->particles);
  point_to_verdicts(command);
}

}  // namespace plumb::app
