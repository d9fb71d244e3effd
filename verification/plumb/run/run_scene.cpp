#include "verification/plumb/run/run_scene.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/output/file.hpp"
#include "lib/run/frame.hpp"
#include "verification/plumb/body_plot.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/run/result_folder.hpp"
#include "verification/plumb/run/run_with_files.hpp"
#include "verification/plumb/run/summary.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/usage.hpp"

namespace plumb::app {
namespace {

/// "out/bending-column" for the scene "bending column".
std::string default_folder(const Scene& scene) {
  std::string name = scene.name;
  for (char& c : name)
    if (c == ' ' || c == '/') c = '-';
  if (name.front() == '.') name.front() = '-';  // ".." is not a place for results
  return "out/" + name;
}

/// The checkpoint that --resume continues; none without it.
std::optional<Checkpoint> starting_point(const RunOptions& options, const std::filesystem::path& file,
                                         const std::map<std::string, std::string>& settings) {
  if (!options.resume) return std::nullopt;
  Checkpoint checkpoint = read_checkpoint(file);
  require_same_origin(checkpoint, version_text(), settings, file.string());
  return checkpoint;
}

/// What to type to continue a run that was stopped.
std::string line_to_resume(const RunOptions& options, const std::filesystem::path& folder) {
  std::vector<std::string> words{"run", options.scene.file};
  for (const auto& change : options.scene.overrides) {
    words.emplace_back("--set");
    words.push_back(change);
  }
  for (const auto& word : {std::string("--out"), folder.string(), std::string("--resume")})
    words.push_back(word);
  return shell_line(words);
}

/// The run is over: its summary once more.
int tell_completed(const Session& session, const ResultFolder& folder, nlohmann::ordered_json summary) {
  session.text() << fmt::format("{}: this run is complete, t = {:.6g} s after {} steps\n  see: {}\n",
                                summary["scene"].get<std::string>(), summary["time"].get<double>(),
                                summary["steps"].get<long>(), folder.summary().string());
  for (const char* head : {"plumbline", "command", "provenance"}) summary.erase(head);
  session.write_json(summary);
  return 0;
}

/// From this many particles on the steps are shared out, unless the user says how. Measured on two cores that
/// others used too: at 4200 particles two threads took four times as long as one, at 8300 as long with 1.6
/// times its CPU time, at 16600 three quarters as long.
constexpr Index worth_threads = 10000;

/// Files that the run has left, for people.
template <int d>
std::string files_text(const ResultFolder& folder, const Recorder<d>& recorder, bool budget) {
  auto files = recorder.files();
  if (budget) files.push_back(folder.budget());
  std::string text = folder.summary().string();
  for (const auto& file : files) text += ", " + file.filename().string();
  return "  see: " + text + "\n";
}

/// What a run that did not come to its end has kept.
std::string kept_text(const RunOptions& options, const ResultFolder& folder, double time, bool stopped) {
  std::string text = fmt::format("  kept: all rows up to t = {:.6g} s, and the state there in {}\n", time,
                                 folder.checkpoint().string());
  if (stopped) text += "  to go on: " + line_to_resume(options, folder.path()) + '\n';
  return text;
}

/// Runs the scene; `folder` null: no files are kept.
template <int d>
int run_into(ResultFolder* folder, const Session& session, const Scene& scene, const RunOptions& options,
             double start) {
  const auto settings = settings_of(options.scene);
  const auto from = folder ? starting_point(options, folder->checkpoint(), settings) : std::nullopt;
  const Output output = scene.output.value_or(Output{});
  auto [simulation, tlsph] = make_simulation<d>(scene);
  if (session.threads == 0 && simulation.counts().particles < worth_threads) omp_set_num_threads(1);
  for (const auto& warning : simulation.warnings) session.warn(warning);
  RunRecord record = from ? restore(*from, simulation) : begin_record(simulation);
  std::optional<Checkpoints<d>> checkpoints;
  if (folder) {
    folder->make(from.has_value());
    checkpoints.emplace(folder->checkpoint(), output.checkpoint, version_text(), settings);
  }
  Recorder<d> recorder(output, folder ? folder->path() : "", simulation, from ? &record : nullptr);
  if (output.budget) simulation.keep_budget(folder->budget());
  record.setup_s = wall_time() - start;
  const RunFiles<d> files{recorder, checkpoints ? &*checkpoints : nullptr};
  const RunResult result = run_with_files(scene.name, simulation, record, files, session.progress());
  const FinishedRun<d> finished{scene, simulation, tlsph.get(), result, recorder.probes(), record};
  auto json = summary(finished);
  json["settings"] = settings;
  session.text() << summary_text(finished);
  if (folder) {
    session.write_json_file(json, folder->summary(), result.completed() ? 0 : 1);
    if (result.completed()) std::filesystem::remove(folder->checkpoint());  // there is nothing to go on with
    if (!result.completed())
      session.text() << kept_text(options, *folder, simulation.steps.now().time, result.stopped);
    session.text() << files_text(*folder, recorder, output.budget);
  }
  session.write_json(json);
  if (!session.csv.empty()) session.write_csv(Frame<d>(simulation.snapshot()).table());
  if (draws(session)) draw(session, body_plot<d>(scene.name, simulation.snapshot(), simulation.spacing));
  return result.completed() ? 0 : result.stopped ? interrupt_exit_code() : 1;
}

}  // namespace

template <int d>
int run_scene(const Session& session, const Scene& scene, const RunOptions& options, double start) {
  if (!scene.output && !options.resume && options.folder.empty())
    return run_into<d>(nullptr, session, scene, options, start);
  ResultFolder folder(options.folder.empty() ? default_folder(scene) : options.folder);
  if (options.resume) {
    const auto complete = completed_summary(folder.path(), settings_of(options.scene));
    if (complete) return tell_completed(session, folder, *complete);
    if (scene.output && scene.output->budget)
      throw InputError("--resume does not go with budget",
                       "the account of the first part of the run is not kept",
                       "run from the start, or --set output.budget=false");
  } else if (!options.overwrite) {
    require_no_checkpoint(folder.path());
  }
  return run_into<d>(&folder, session, scene, options, start);
}

template int run_scene<1>(const Session&, const Scene&, const RunOptions&, double);
template int run_scene<2>(const Session&, const Scene&, const RunOptions&, double);
template int run_scene<3>(const Session&, const Scene&, const RunOptions&, double);

}  // namespace plumb::app
