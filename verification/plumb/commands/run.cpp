#include <CLI/CLI.hpp>
#include <memory>

#include "verification/plumb/commands.hpp"
#include "verification/plumb/run/run_scene.hpp"
#include "verification/plumb/run/run_with_files.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

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
      {.table = true, .plot = true}, action);
  add_scene_options(command, options->scene);
  command
      .add_option("--out", options->folder, "folder for series, particles and summary (default: out/NAME)")
      ->type_name("DIR")
      ->check([](const std::string& name) {
        return std::string(name.empty() ? "the folder name is empty" : "");
      });
  CLI::Option* resume =
      command.add_flag("--resume", options->resume,
                       "continue from the checkpoint in that folder, with the same bits as if never stopped");
  command
      .add_flag("--overwrite", options->overwrite,
                "begin anew although the folder holds the checkpoint of a run that did not come to its end")
      ->excludes(resume);
}

}  // namespace plumb::app
