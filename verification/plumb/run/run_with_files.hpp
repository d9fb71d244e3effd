#pragma once
#include "lib/output/progress.hpp"
#include "lib/run/checkpoints.hpp"
#include "lib/run/recorder.hpp"

namespace plumb::app {

/// What is written while a run goes on; null: it is not.
template <int d>
struct RunFiles {
  Recorder<d>& recorder;
  Checkpoints<d>* checkpoints;
};

/// Runs the steps until the end or a signal, and keeps the record. What an early end leaves can be continued.
template <int d>
RunResult run_with_files(const std::string& name, Simulation<d>& simulation, RunRecord& record,
                         const RunFiles<d>& files, Progress::Style style);

/// Wall time of this machine's steady clock [s].
double wall_time();

}  // namespace plumb::app
