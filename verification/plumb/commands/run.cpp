#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/commands.hpp"
#include "plumb/run/interrupt.hpp"
#include "plumb/run/recorder.hpp"
#include "plumb/run/scene_options.hpp"
#include "plumb/run/summary.hpp"
#include "plumb/session.hpp"
#include "plumbline/output/file.hpp"

namespace plumb {
namespace {

struct RunOptions {
  SceneOptions scene;
  std::string folder;
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

/// Runs the steps, recording on the way; adds the time they took.
template <int d>
RunResult advance(const Session& session, const Scene& scene, Simulation<d>& simulation,
                  Recorder<d>& recorder, Timing& timing) {
  const InterruptGuard guard;
  Progress progress(scene.name, session.progress());
  const double wall = wall_time(), cpu = cpu_time();
  const auto observe = [&](const Solid<d>& solid, const State<d>& state) {
    recorder.observe(solid, state);
    progress.update(fraction_done(simulation.control, state),
                    fmt::format("t = {:.4g} s, step {}", state.time, state.step));
    return !interrupted();
  };
  const RunResult result =
      run<d>(simulation.solid, simulation.state, simulation.stepper, simulation.control, observe);
  timing.wall = wall_time() - wall;
  timing.cpu = cpu_time() - cpu;
  recorder.finish(simulation.solid, simulation.state);
  return result;
}

template <int d>
int run_scene(const Session& session, const Scene& scene, const RunOptions& options, double start) {
  const bool keeps_files = scene.output || !options.folder.empty();
  const std::filesystem::path folder = options.folder.empty() ? default_folder(scene) : options.folder;
  if (keeps_files) require_folder(folder, "--out");
  Simulation<d> simulation = make_simulation<d>(scene);
  for (const auto& warning : simulation.warnings) session.warn(warning);
  Recorder<d> recorder(scene, folder, simulation.solid);
  const Energy energy = energy_of(simulation.solid, simulation.state);
  const Momentum momentum = momentum_of(simulation.solid, simulation.state);
  Timing timing{.setup = wall_time() - start};
  const RunResult result = advance(session, scene, simulation, recorder, timing);
  const FinishedRun<d> finished{scene, simulation, result, recorder.probes(), energy, momentum, timing};
  const auto json = summary(finished);
  session.text() << summary_text(finished);
  if (keeps_files) {
    std::filesystem::create_directories(folder);
    session.write_json_file(json, folder / "summary.json");
    session.text() << "  files in " << folder.string() << '\n';
  }
  session.write_json(json);
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
      {"run", "run a scene", "plumb run verification/scenes/swinging-plate.toml --set body.spacing=0.1"}, {},
      action);
  add_scene_options(command, options->scene);
  command
      .add_option("--out", options->folder, "folder for series, particles and summary (default: out/NAME)")
      ->type_name("DIR");
}

}  // namespace plumb
