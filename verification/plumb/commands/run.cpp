#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/commands.hpp"
#include "plumb/provenance.hpp"
#include "plumb/run/budget_file.hpp"
#include "plumb/run/checkpoints.hpp"
#include "plumb/run/frame.hpp"
#include "plumb/run/interrupt.hpp"
#include "plumb/run/recorder.hpp"
#include "plumb/run/scene_options.hpp"
#include "plumb/run/summary.hpp"
#include "plumb/session.hpp"
#include "plumb/usage.hpp"
#include "plumbline/output/file.hpp"

namespace plumb {
namespace {

struct RunOptions {
  SceneOptions scene;
  std::string folder;
  bool resume = false;
};

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double cpu_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// "out/bending-column" for the scene "bending column".
std::string default_folder(const Scene& scene) {
  std::string name = scene.name;
  for (char& c : name)
    if (c == ' ' || c == '/') c = '-';
  if (name.front() == '.') name.front() = '-';  // ".." is not a place for results
  return "out/" + name;
}

/// Share of the run that is done.
template <int d>
double fraction_done(const StepControl& control, const State<d>& state) {
  double fraction = 0;
  if (control.end_time) fraction = state.time / *control.end_time;
  if (control.max_steps)
    fraction = std::max(fraction, static_cast<double>(state.step) / static_cast<double>(*control.max_steps));
  return fraction;
}

/// Time that passes while it lives, added to the time of a run that may have been continued.
class Stopwatch {
 public:
  explicit Stopwatch(Timing& timing) : timing_(timing), before_(timing) {}
  void read() const {
    timing_.wall = before_.wall + wall_time() - wall_;
    timing_.cpu = before_.cpu + cpu_time() - cpu_;
  }

 private:
  Timing& timing_;
  Timing before_;
  double wall_ = wall_time(), cpu_ = cpu_time();
};

/// Runs the steps, recording on the way. What an early end leaves can be continued.
template <int d>
RunResult advance(const Session& session, const Scene& scene, Simulation<d>& simulation, RunBook& book,
                  Recorder<d>& recorder, Checkpoints<d>* checkpoints, BudgetFile<d>* budget) {
  const InterruptGuard guard;
  Progress progress(scene.name, session.progress());
  const Stopwatch watch(book.timing);
  const double start = wall_time();
  const long first = simulation.state.step;
  const double before = fraction_done(simulation.control, simulation.state);
  const auto keep = [&] {
    watch.read();
    checkpoints->write(simulation, book, recorder.mark());
  };
  const auto observe = [&](const Solid<d>& solid, const State<d>& state) {
    recorder.observe(solid, state);
    if (budget) budget->observe(solid, state);
    if (checkpoints && checkpoints->due(state.time)) keep();
    progress.update(fraction_done(simulation.control, state),
                    fmt::format("t = {:.4g} s, step {}, {:.3g} steps/s", state.time, state.step,
                                static_cast<double>(state.step - first) / (wall_time() - start)),
                    before);
    return !interrupted();
  };
  const RunResult result = run<d>(simulation.solid, simulation.state, simulation.stepper, simulation.control,
                                  observe, book.history);
  // before the recorder's last row, which a run that goes on would not have
  if (checkpoints && !result.completed()) keep();
  watch.read();
  recorder.finish(simulation.solid, simulation.state);
  return result;
}

/// The checkpoint that --resume continues; none without it, and then an old one is taken away.
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

template <int d>
int run_scene(const Session& session, const Scene& scene, const RunOptions& options, double start) {
  const bool keeps_files = scene.output || options.resume || !options.folder.empty();
  const std::filesystem::path folder = options.folder.empty() ? default_folder(scene) : options.folder;
  if (keeps_files) require_folder(folder, "--out");
  const auto settings = settings_of(options.scene);
  const auto file = folder / "checkpoint.h5";
  const auto from = starting_point(options, file, settings);
  Simulation<d> simulation = make_simulation<d>(scene);
  const bool with_budget = scene.output && scene.output->budget;
  if (with_budget && options.resume)
    throw InputError("--resume does not go with budget",
                     "the account of the first part of the run is not kept",
                     "run from the start, or --set output.budget=false");
  for (const auto& warning : simulation.warnings) session.warn(warning);
  RunBook book = from ? restore(*from, simulation) : begin_book(simulation);
  if (keeps_files) make_folder(folder, "--out");
  if (keeps_files && !from) std::filesystem::remove(file);
  Recorder<d> recorder(scene, folder, simulation.solid, from ? std::optional(from->recorder) : std::nullopt);
  std::optional<Checkpoints<d>> checkpoints;
  if (keeps_files) {
    checkpoints.emplace(file, scene.output.value_or(Output{}).checkpoint, version_text(), settings);
  }
  std::optional<BudgetFile<d>> budget;
  if (with_budget) budget.emplace(folder / "budget.csv", simulation);
  book.timing.setup = wall_time() - start;
  const RunResult result = advance(session, scene, simulation, book, recorder,
                                   checkpoints ? &*checkpoints : nullptr, budget ? &*budget : nullptr);
  const FinishedRun<d> finished{scene, simulation, result, recorder.probes(), book};
  const auto json = summary(finished);
  session.text() << summary_text(finished);
  if (keeps_files) {
    session.write_json_file(json, folder / "summary.json", result.completed() ? 0 : 1);
    session.text() << "  files in " << folder.string() << '\n';
    if (!result.completed())
      session.text() << fmt::format("  kept: all rows up to t = {:.6g} s, and the state there in {}\n",
                                    simulation.state.time, file.string());
    if (result.stopped) session.text() << "  to go on: " << line_to_resume(options, folder) << '\n';
  }
  session.write_json(json);
  if (!session.csv.empty())
    session.write_csv(Frame<d>(simulation.solid, simulation.state, scene.material).table());
  return result.completed() ? 0 : 1;
}

}  // namespace

/// `plumb run SCENE.toml`: runs a scene; exit code 1 if it becomes unstable.
void add_run(CLI::App& program, Session& session) {
  const auto options = std::make_shared<RunOptions>();
  const auto action = [&session, options] {
    const double start = wall_time();
    const Scene scene = scene_of(options->scene);
    return with_dimension(scene, [&]<int d>() { return run_scene<d>(session, scene, *options, start); });
  };
  CLI::App& command = add_command(
      program, session,
      {"run", "run a scene", "plumb run verification/scenes/swinging-plate.toml --set body.spacing=0.1"},
      {.table = true}, action);
  add_scene_options(command, options->scene);
  command
      .add_option("--out", options->folder, "folder for series, particles and summary (default: out/NAME)")
      ->type_name("DIR");
  command.add_flag("--resume", options->resume,
                   "continue from the checkpoint in that folder, with the same bits as if never stopped");
}

}  // namespace plumb
