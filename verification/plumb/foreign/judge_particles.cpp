#include "verification/plumb/foreign/judge_particles.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "lib/output/table.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

double time_of(const std::string& text) {
  if (text.empty())
    throw InputError("--particles without --time", "the solution moves",
                     "give the time of the files, such as --time \"5 ms\"");
  return seconds_of(text);
}

/// The levels as a table for people.
Json shown(const std::vector<ForeignErrors>& levels) {
  Json rows = Json::array();
  for (const ForeignErrors& level : levels) {
    Json row{{"file", level.file}, {"points", level.points}, {"h [m]", level.spacing}};
    for (const auto& [name, value] : level.norms)
      if (name != "l2_inside" && name != "l2_boundary") row[name] = value;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<RunsOfLevel> runs_of_levels(std::vector<std::pair<double, double>> levels) {
  constexpr double same = 0.01;  // random clouds of one spacing differ by less; refinement means more
  std::stable_sort(levels.begin(), levels.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<RunsOfLevel> runs;
  for (const auto& [h, error] : levels) {
    if (runs.empty() || h < (1 - same) * runs.back().spacing) runs.push_back({h, {}});
    runs.back().values.push_back(error);
  }
  return runs;
}

std::vector<JudgedColumn> judged_levels(const std::vector<ForeignErrors>& levels,
                                        const std::vector<std::string>& norms,
                                        const std::vector<double>& expect) {
  const auto declared = declared_orders(expect, norms.size());
  std::vector<JudgedColumn> columns;
  for (std::size_t k = 0; k < norms.size(); ++k) {
    std::vector<std::pair<double, double>> pairs;
    for (const ForeignErrors& level : levels) {
      const auto found = level.norms.find(norms[k]);
      if (found == level.norms.end()) {
        std::vector<std::string> known;
        for (const auto& entry : level.norms) known.push_back(entry.first);
        throw unknown_name("norm of " + level.file, norms[k], known);
      }
      pairs.emplace_back(level.spacing, found->second);
    }
    columns.push_back(judged_column(norms[k], runs_of_levels(pairs), declared[k]));
  }
  return columns;
}

nlohmann::ordered_json json_of(const ForeignErrors& level) {
  Json json{{"file", level.file},
            {"n", level.points},
            {"h", level.spacing},
            {"volume", level.volume},
            {"estimated_volumes", level.estimated_volumes}};
  for (const auto& [name, value] : level.norms) json[name] = value;
  json["worst"] = level.worst;
  json["suspicion"] = level.suspicion;
  json["region"] = level.region;
  return json;
}

std::vector<std::string> causes_of(const std::vector<ForeignErrors>& levels,
                                   const std::vector<JudgedColumn>& columns) {
  const bool nothing_to_explain = std::all_of(columns.begin(), columns.end(), [](const JudgedColumn& column) {
    return column.verdict == "pass" || column.verdict == "asymptotic" || column.verdict == "too-few-levels";
  });
  if (nothing_to_explain || levels.empty()) return {};
  const auto finest = std::min_element(levels.begin(), levels.end(),
                                       [](const auto& a, const auto& b) { return a.spacing < b.spacing; });
  // an error that falls is of the discretisation, whatever it looks like
  const OrderFit fit = judged_levels(levels, {"l2"}, {}).front().fit;
  const bool falls = !fit.pairwise.empty() && fit.pairwise.back() > 0.5;
  std::vector<std::string> causes = falls ? std::vector<std::string>{} : finest->suspicion;
  causes.push_back(finest->region);
  std::string orders;
  for (const JudgedColumn& column : judged_levels(levels, {"l2", "linf", "l2_inside", "l2_boundary"}, {}))
    if (std::isfinite(column.fit.order))
      orders += fmt::format("{}{} {:.2f}", orders.empty() ? "" : ", ", column.name, column.fit.order);
  if (!orders.empty()) causes.push_back(fmt::format("Orders: {}.", orders));
  return causes;
}

void add_particle_options(CLI::App& command, ParticleOptions& options) {
  command
      .add_option("--particles", options.files,
                  "instead of a table, what the program wrote of its points, one file for each level and "
                  "run: .vtp, .vtu, HDF5, "
                  ".csv or a LAMMPS dump, with a displacement and whatever else it has (velocity, F, P, "
                  "stress, volume)")
      ->type_name("FILE ...");
  command
      .add_option("--solution", options.solution.name,
                  "with --particles: the manufactured solution that they shall be")
      ->type_name("NAME");
  command.add_option("--time", options.time, "with --particles: time of the files, such as \"5 ms\"")
      ->type_name("TIME");
  command
      .add_option("--spacings", options.spacings,
                  "with --particles: spacing of each file [m] (default: mean distance of nearest neighbours)")
      ->delimiter(',');
  command
      .add_option("--positions", options.points.positions,
                  "with --particles: whether positions are those of the body at rest or those of now "
                  "(default: current in "
                  ".vtp and dumps, reference in all others)")
      ->check(CLI::IsMember({"reference", "current"}));
  command
      .add_option("--rest", options.points.rest,
                  "with --particles of one level: a file with the same points at rest")
      ->type_name("FILE");
  add_solution_options(command, options.solution);
}

int judge_particles(const Session& session, const ParticleOptions& options, std::vector<std::string> norms,
                    const std::vector<double>& expect) {
  if (options.solution.name.empty())
    throw InputError("--particles without --solution", "errors are those against a solution",
                     "See `plumb mms --list`.");
  if (!options.spacings.empty() && options.spacings.size() != options.files.size())
    throw InputError(fmt::format("{} spacings for {} files", options.spacings.size(), options.files.size()),
                     "each file has one", "");
  if (!options.points.rest.empty() && options.files.size() > 1)
    throw InputError("--rest with several files", "every level has points of its own",
                     "give reference positions in the files");
  const double time = time_of(options.time);
  SolutionOptions asked = options.solution;
  if (asked.dimension == 0 && mms::solution_entry(asked.name).dimensions.size() > 1)
    asked.dimension = dimension_of(read_points(options.files.front()));
  const SolutionChoice choice = solution_choice(asked);
  std::vector<ForeignErrors> levels;
  for (std::size_t k = 0; k < options.files.size(); ++k) {
    levels.push_back(errors_of(options.files[k], choice, time, options.points));
    if (!options.spacings.empty()) levels.back().spacing = options.spacings[k];
  }
  if (norms.empty()) norms = {"l2"};
  const std::vector<JudgedColumn> columns = judged_levels(levels, norms, expect);
  const std::string status = status_of(columns);
  session.text() << in_words(choice) << fmt::format(", t = {:g} s\n", time)
                 << plain_text(table_of(shown(levels))) << '\n';
  tell_columns(session, columns);
  Json rows = Json::array();
  for (const ForeignErrors& level : levels) rows.push_back(json_of(level));
  const std::vector<std::string> causes = causes_of(levels, columns);
  for (const std::string& cause : causes) session.text() << "  " << cause << '\n';
  session.text() << "status: " << status << '\n';
  session.write_json({{"solution", choice.name},
                      {"time", time},
                      {"levels", rows},
                      {"fits", fits_json(columns)},
                      {"causes", causes},
                      {"status", status}});
  draw_columns(session, choice.name, columns);
  return exit_code_of(status);
}

}  // namespace plumb::app
