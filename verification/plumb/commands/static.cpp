#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/status.hpp"
#include "mms/manufactured.hpp"
#include "mms/static_study.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/mms_output.hpp"
#include "verification/plumb/run/sittings.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct StaticOptions {
  std::string study;
  std::vector<std::string> overrides;
  SittingOptions sitting;
};

Json level_json(const mms::StaticLevel& level) {
  Json row{{"n", level.n}, {"d", level.spacing}};
  for (const mms::NormName& norm : mms::static_norms())
    row[fmt::format("relative_{}", norm.name)] = level.relative(norm.value);
  for (const mms::NormName& norm : mms::static_norms()) row[std::string(norm.name)] = level.error.*norm.value;
  if (level.frequency_error) row["frequency_error"] = *level.frequency_error;
  if (level.projection) {
    row["divergence_defect"] = level.projection->divergence_defect;
    row["residual"] = level.projection->residual;
  }
  if (level.failure) row["status"] = *level.failure;
  row["setup_s"] = level.setup_s;
  row["solve_s"] = level.solve_s;
  return row;
}

int static_action(const Session& session, const StaticOptions& options) {
  std::vector<std::string> names;
  for (const auto& entry : mms::solution_list()) names.push_back(entry.name);
  const Study study = read_study(options.study, options.overrides, names, StudyOf::equilibrium);
  Progress progress(study.name, session.progress());
  const auto tell = [&](double done, const std::string& note) { progress.update(done, note); };
  std::vector<std::string> choices{"static"};
  choices.insert(choices.end(), options.overrides.begin(), options.overrides.end());
  const auto result =
      in_one_sitting(session, options.sitting, {options.study}, choices,
                     [&](Sitting& sitting) { return mms::run_static_study(study, tell, sitting); });
  progress.finish();
  Json levels = Json::array(), fits = Json::array();
  for (const auto& level : result.levels) levels.push_back(level_json(level));
  for (const auto& fit : result.fits) fits.push_back(fit_json(fit));
  session.text() << plain_text(table_of(with_units(levels, study.dimension()))) << '\n'
                 << text_of(result.fits);
  session.write_csv(levels);
  for (const auto& note : study.unused) session.text() << note << '\n';
  session.text() << "status: " << result.status << '\n';
  Json units = Json::object();
  for (const mms::NormName& norm : mms::static_norms())
    units[std::string(norm.name)] = unit_of_norm(norm.name, study.dimension());
  session.write_json({{"study", study.name},
                      {"solution", study.solution},
                      {"levels", levels},
                      {"fits", fits},
                      {"units", units},
                      {"notes", study.unused},
                      {"status", result.status}});
  draw(session, static_picture(study, result));
  return exit_code_of(result.status);
}

}  // namespace

/// `plumb static`: a manufactured field as an equilibrium, and its vibration, with the assembled stiffness.
void add_static(CLI::App& program, Session& session) {
  const auto options = std::make_shared<StaticOptions>();
  CLI::App& command = add_command(program, session,
                                  {"static", "convergence of a linear equilibrium and of a frequency",
                                   "plumb static verification/studies/static_plate.toml --json -"},
                                  {.table = true, .plot = true},
                                  [&session, options] { return static_action(session, *options); });
  command.add_option("study", options->study, "study file (TOML)")->required();
  command.add_option("--set", options->overrides, "change one value of the study; may be repeated")
      ->type_name("section.key=value");
  add_sitting_options(command, options->sitting);
  point_to_verdicts(command);
}

}  // namespace plumb::app
