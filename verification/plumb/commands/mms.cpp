#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/status.hpp"
#include "lib/output/table.hpp"
#include "mms/manufactured.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/foreign/export_solution.hpp"
#include "verification/plumb/mms_cost.hpp"
#include "verification/plumb/mms_output.hpp"
#include "verification/plumb/run/sittings.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct MmsOptions {
  std::vector<std::string> studies;
  std::string check;
  std::vector<std::string> overrides, vary;
  bool list = false, temporal = false, work_precision = false;
  int repeats = 3;
  std::size_t points = 1000;
  std::uint64_t seed = 1;
  SittingOptions sitting;
  ExportOptions exported;
};

int list(const Session& session) {
  for (const auto& entry : mms::solution_list()) {
    std::string dimensions;
    for (const int d : entry.dimensions)
      dimensions += fmt::format("{}{}D", dimensions.empty() ? "" : ", ", d);
    session.text() << fmt::format("{} ({}): {}\n", entry.name, dimensions, entry.summary);
    for (const auto& p : entry.parameters.all())
      session.text() << fmt::format("    {} = {:g}{}, from {:g} to {:g}: {}\n", p.name, p.value,
                                    p.unit == "1" ? "" : fmt::format(" {}", p.unit), p.least, p.most,
                                    p.meaning);
  }
  session.write_json(solutions_json());
  return 0;
}

int check(const Session& session, const MmsOptions& options) {
  const auto checks = mms::check_solution(options.check, options.points, options.seed);
  bool passed = true;
  for (const auto& one : checks) passed = passed && one.passed;
  const Json rows = json_of(checks);
  session.write_table(rows);
  const std::string status = passed ? "pass" : "fail";
  session.text() << fmt::format("two derivations compared, relative; tolerance {:g}: {}\n",
                                mms::check_tolerance, status);
  session.write_json({{"tolerance", mms::check_tolerance}, {"rows", rows}, {"status", status}});
  return exit_code_of(status);
}

/// One sitting of what is asked for.
template <class Work>
auto in_one_sitting(const Session& session, const MmsOptions& options, const std::string& mode, Work&& work) {
  std::vector<std::string> choices{mode};
  choices.insert(choices.end(), options.overrides.begin(), options.overrides.end());
  choices.insert(choices.end(), options.vary.begin(), options.vary.end());
  return app::in_one_sitting(session, options.sitting, options.studies, choices, work);
}

/// The study that is given, which must be one.
Study only_study(const MmsOptions& options, StudyOf use, const char* what_it_is) {
  if (options.studies.size() != 1)
    throw InputError("several study files", std::string(what_it_is) + " is one",
                     "Add --work-precision to compare them.");
  return read_study(options.studies.front(), options.overrides, mms::solution_names(), use);
}

int temporal(const Session& session, const MmsOptions& options) {
  const Study study = only_study(options, StudyOf::time, "a refinement of the time step");
  Progress progress(study.name, session.progress());
  const auto result = in_one_sitting(session, options, "temporal", [&](Sitting& sitting) {
    return mms::run_temporal(study, told(progress), sitting);
  });
  progress.finish();
  const Json json = json_of(study, result);
  std::vector<FitLine> lines;
  for (const auto& order : result.orders)
    lines.push_back({order.integrator, order.fit, order.declared, order.verdict});
  session.text() << plain_text(table_of(with_units(json["rows"], study.dimension()))) << '\n'
                 << fits_text(lines);
  session.write_csv(json["rows"]);
  session.text() << fmt::format("error in space: l2 {:.4g} {}\nstatus: {}\n", result.spatial_error,
                                unit_of_norm("l2", study.dimension()), result.status);
  draw(session, temporal_picture(study, result));
  session.write_json(json);
  return exit_code_of(result.status);
}

/// What the studies say and this command does not look at, once each.
std::set<std::string> notes_of(const std::vector<mms::Contender>& variants) {
  std::set<std::string> notes;
  for (const auto& variant : variants) notes.insert(variant.study.unused.begin(), variant.study.unused.end());
  return notes;
}

int work_precision(const Session& session, const MmsOptions& options) {
  const auto variants = variants_of(options.studies, options.vary, options.overrides, mms::solution_names());
  Progress progress("work-precision", session.progress());
  const auto result = in_one_sitting(session, options, "work-precision", [&](Sitting& sitting) {
    return mms::work_precision(variants, options.repeats, {1e-2, 1e-3, 1e-4}, told(progress), sitting);
  });
  progress.finish();
  Json json = json_of(result, options.repeats);
  json["notes"] = notes_of(variants);
  session.write_table(json["points"]);
  for (const auto& c : result.cheapest)
    session.text() << fmt::format("relative error {:g}: cheapest {} = {:.4g}, {}\n", c.error, c.measure,
                                  c.cost, result.labels[c.variant]);
  for (const auto& note : json["notes"]) session.text() << note.get<std::string>() << '\n';
  const auto status = json["status"].get<std::string>();
  session.text() << "status: " << status << '\n';
  draw(session, work_picture(result));
  session.write_json(json);
  return exit_code_of(status);
}

int study(const Session& session, const MmsOptions& options) {
  const Study study = only_study(options, StudyOf::space, "a refinement study");
  Progress progress(study.name, session.progress());
  const auto result = in_one_sitting(session, options, "study", [&](Sitting& sitting) {
    return mms::run_study(study, told(progress), sitting);
  });
  progress.finish();
  const Json json = json_of(study, result);
  for (const bool relative : {true, false})
    session.text() << plain_text(table_of(with_units(shown(json["levels"], relative), study.dimension())))
                   << '\n';
  session.text() << "relative velocity and stress errors, pair evaluations: --csv or --json\n\n"
                 << text_of(result.fits);
  session.write_csv(json["levels"]);
  for (const auto& note : result.notes) session.text() << note << '\n';
  session.text() << "status: " << result.status << '\n';
  draw(session, study_picture(study, result));
  session.write_json(json);
  return exit_code_of(result.status);
}

/// What stands in the place of a study is the name of a solution.
int export_named(const Session& session, const MmsOptions& options) {
  if (options.studies.size() != 1)
    throw InputError("--export without the name of a solution", "one is written at a time",
                     "plumb mms --export c swinging-plate");
  ExportOptions asked = options.exported;
  asked.solution.name = options.studies.front();
  asked.solution.overrides = options.overrides;
  return export_solution(session, asked);
}

/// Refuses files that what is asked for does not fill.
void require_no_idle_files(const Session& session, const MmsOptions& options) {
  const bool draws = options.exported.format.empty() && options.check.empty() && !options.list;
  if (!draws && !session.plot.empty())
    throw InputError("--plot beside --list, --check or --export", "it draws the errors of a study",
                     "Leave it out.");
  if (!draws && options.check.empty() && !session.csv.empty())
    throw InputError("--csv beside --list or --export", "it holds the rows of a study or of --check",
                     "Leave it out; --export csv --out FILE writes a solution.");
}

int mms_action(const Session& session, const MmsOptions& options) {
  require_no_idle_files(session, options);
  if (!options.exported.format.empty()) return export_named(session, options);
  const int asked = int(options.list) + int(!options.check.empty()) + int(!options.studies.empty());
  if (asked != 1)
    throw InputError(asked == 0 ? "nothing was asked for" : "several things were asked for",
                     "plumb mms does one at a time",
                     "give a study file, or --list, or --check NAME. To begin: plumb new study first.toml");
  if (options.list) return list(session);
  if (!options.check.empty()) return check(session, options);
  if (options.work_precision) return work_precision(session, options);
  if (options.temporal) return temporal(session, options);
  return study(session, options);
}

void add_export_options(CLI::App& command, ExportOptions& exported) {
  const auto format =
      command
          .add_option(
              "--export", exported.format,
              "writes the solution whose name is given, with its loads, as source text, or as a table of "
              "values")
          ->check(CLI::IsMember({"c", "fortran", "python", "csv"}));
  command.add_option("--dimension", exported.solution.dimension, "with --export: 1, 2 or 3")
      ->check(CLI::IsMember({1, 2, 3}))
      ->needs(format);
  command.add_option("--at", exported.points, "with --export csv: a file of points (.csv, .vtp, .vtu, dump)")
      ->type_name("FILE")
      ->needs(format);
  command.add_option("--time", exported.time, "with --export csv: the time, such as \"5 ms\"")
      ->type_name("TIME")
      ->needs(format);
  command.add_option("--out", exported.out, "with --export: a file (default: standard output)")
      ->type_name("FILE")
      ->needs(format);
}

}  // namespace

/// `plumb mms`: convergence studies with manufactured solutions.
void add_mms(CLI::App& program, Session& session) {
  const auto options = std::make_shared<MmsOptions>();
  CLI::App& command = add_command(program, session,
                                  {"mms", "convergence study with a manufactured solution",
                                   "plumb mms --check swinging-plate --points 100"},
                                  {.table = true, .plot = true},
                                  [&session, options] { return mms_action(session, *options); });
  command.add_option("study", options->studies, "the study file (.toml); several with --work-precision")
      ->type_name("STUDY ...");
  const auto list =
      command.add_flag("--list", options->list, "the catalogue of solutions with their parameters");
  const auto check = command
                         .add_option("--check", options->check,
                                     "compares the two derivations of a solution at random points")
                         ->type_name("SOLUTION");
  command.add_option("--points", options->points, "number of random points of --check")
      ->capture_default_str()
      ->needs(check);
  command.add_option("--seed", options->seed, "seed of --check")->capture_default_str()->needs(check);
  const auto temporal =
      command.add_flag("--temporal", options->temporal,
                       "orders of the integrators: the step halved five times on the one cloud of the study");
  const auto cost =
      command.add_flag("--work-precision", options->work_precision,
                       "error against CPU time and work of several methods, with the Pareto front");
  cost->excludes(temporal);
  command
      .add_option("--vary", options->vary,
                  "with --work-precision: values of a key; every combination is a method")
      ->type_name("section.key=V1,V2,..")
      ->needs(cost);
  command.add_option("--repeats", options->repeats, "with --work-precision: timed runs after the first")
      ->capture_default_str()
      ->check(CLI::Range(1, 100))
      ->needs(cost);
  add_export_options(command, options->exported);
  command
      .add_option("--set", options->overrides,
                  "change one value of the study; with --export a parameter of the solution "
                  "(parameters.amplitude=0.02) or a "
                  "key of [material]; may be repeated")
      ->type_name("section.key=value")
      ->excludes(list)
      ->excludes(check);
  add_sitting_options(command, options->sitting);
  point_to_verdicts(command);
}

}  // namespace plumb::app
