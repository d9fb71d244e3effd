#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "mms/manufactured.hpp"
#include "mms/operators.hpp"
#include "reports/picture.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct OperatorOptions {
  std::string study;
  std::vector<std::string> overrides;
};

/// "Div P", "inside" as "div_p_inside".
std::string key_of(std::string_view name, std::string_view part) {
  std::string key;
  for (const char c : name) key += c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  return fmt::format("{}_{}", key, part);
}

Json level_json(const mms::OperatorLevel& level) {
  Json row{{"n", level.n}, {"d", level.spacing}};
  for (std::size_t k = 0; k < mms::operator_names.size(); ++k)
    for (std::size_t part = 0; part < mms::part_names.size(); ++part)
      row[key_of(mms::operator_names[k], mms::part_names[part])] = level.error[k][part];
  row["constraint_inside"] = level.constraint;
  return row;
}

Json operator_fit_json(const mms::OperatorFit& fit) {
  return {{"operator", fit.name},
          {"part", fit.part},
          {"order", fit.fit.order},
          {"ci95", {fit.fit.lower, fit.fit.upper}},
          {"pairwise", fit.fit.pairwise},
          {"drift", fit.fit.drift},
          {"levels", fit.fit.levels.size()},
          {"verdict", fit.verdict}};
}

reports::Picture picture_of(const Study& study, const Json& levels, const mms::OperatorResult& result) {
  reports::Picture picture;
  picture.title = study.name + ": operators on the exact field";
  picture.x = {"spacing", "m", reports::Scale::log};
  picture.y = {"relative error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const auto& fit : result.fits) {
    reports::Series series;
    series.label = fit.name + ", " + fit.part;
    for (const auto& level : levels) {
      series.x.push_back(level.at("d").get<double>());
      series.y.push_back(level.at(key_of(fit.name, fit.part)).get<double>());
    }
    const auto positive = [](double y) { return y > 0; };  // an operator that is exact has no logarithm
    if (std::any_of(series.y.begin(), series.y.end(), positive)) picture.series.push_back(series);
  }
  return picture;
}

int operators_action(const Session& session, const OperatorOptions& options) {
  std::vector<std::string> names;
  for (const auto& entry : mms::solution_list()) names.push_back(entry.name);
  const Study study = read_study(options.study, options.overrides, names, StudyOf::operators);
  Progress progress(study.name, session.progress());
  const mms::OperatorResult result =
      mms::run_operators(study, [&](double done, const std::string& note) { progress.update(done, note); });
  progress.finish();
  Json levels = Json::array(), fits = Json::array();
  for (const auto& level : result.levels) levels.push_back(level_json(level));
  session.text()
      << plain_text(table_of(with_units(levels, study.dimension())))
      << "errors are relative to the exact F - I, Div P and Laplacian over the body; Div P against "
         "Div P - P B/V\n\n";
  session.write_csv(levels);
  std::vector<FitLine> lines;
  for (const auto& fit : result.fits) {
    fits.push_back(operator_fit_json(fit));
    lines.push_back({fit.name + ", " + fit.part, fit.fit, std::nullopt, fit.verdict});
  }
  session.text() << fits_text(lines);
  for (const auto& note : study.unused) session.text() << note << '\n';
  session.text() << "status: " << result.status << '\n';
  if (!session.plot.empty())
    for (const auto& dropped : reports::save(picture_of(study, levels, result), session.plot))
      session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
  session.write_json({{"study", study.name},
                      {"solution", study.solution},
                      {"levels", levels},
                      {"fits", fits},
                      {"notes", study.unused},
                      {"status", result.status}});
  return exit_code_of(result.status);
}

}  // namespace

/// `plumb operators`: F, Div P, the Laplacian and the integration constraint, without time.
void add_operators(CLI::App& program, Session& session) {
  const auto options = std::make_shared<OperatorOptions>();
  CLI::App& command = add_command(
      program, session,
      {"operators", "errors of F, Div P and the Laplacian on an exact field; integration constraint",
       "plumb operators verification/studies/operators.toml --set method.momentum=symmetrised"},
      {.table = true, .plot = true}, [&session, options] { return operators_action(session, *options); });
  command.add_option("study", options->study, "study file (TOML); its end time is the time of the field")
      ->required();
  command.add_option("--set", options->overrides, "change one value of the study; may be repeated")
      ->type_name("section.key=value");
  point_to_verdicts(command);
}

}  // namespace plumb::app
