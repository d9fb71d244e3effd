#pragma once
#include <string>

#include "verification/plumb/run/scene_options.hpp"

namespace plumb::app {
struct Session;

/// What `plumb run` was told beside the scene.
struct RunOptions {
  SceneOptions scene;
  std::string folder;  ///< empty: out/NAME
  bool resume = false, overwrite = false;
};

/// Runs a scene and keeps its files; returns the exit code. `start`: wall_time() when reading began. In this order:
///   ResultFolder                       takes the folder, or refuses it: another run, a checkpoint, a completed run
///   read_checkpoint                    with --resume, and whether it is of this scene and this program
///   make_simulation -> Simulation      the scheme is forgotten from here on
///   begin_record | restore             RunRecord: what the run remembers
///   ResultFolder::make                 removes what an earlier run left
///   Recorder, Checkpoints, keep_budget series.csv, particles.pvd, checkpoint.h5, budget.csv
///   run_with_files                     every step: Recorder::observe makes a Snapshot and writes when a row is due;
///                                      Recorder::note and Checkpoints::write when a checkpoint is due or the run ends early
///   summary                            summary.json, --json, text
template <int d>
int run_scene(const Session& session, const Scene& scene, const RunOptions& options, double start);

}  // namespace plumb::app
