#include "verification/plumb/run/run_with_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <functional>

#include "verification/plumb/run/interrupt.hpp"

namespace plumb::app {
namespace {

double cpu_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Share of the run that is done.
double fraction_done(const StepControl& control, const Moment& now) {
  double fraction = 0;
  if (control.end_time) fraction = now.time / *control.end_time;
  if (control.max_steps)
    fraction = std::max(fraction, static_cast<double>(now.step) / static_cast<double>(*control.max_steps));
  return fraction;
}

/// Time that passes while it lives, added to the time of a run that may have been continued.
class Stopwatch {
 public:
  explicit Stopwatch(RunRecord& record)
      : record_(record), wall_before_(record.wall_s), cpu_before_(record.cpu_s) {}
  void read() const {
    record_.wall_s = wall_before_ + wall_time() - wall_;
    record_.cpu_s = cpu_before_ + cpu_time() - cpu_;
  }

 private:
  RunRecord& record_;
  double wall_before_, cpu_before_;
  double wall_ = wall_time(), cpu_ = cpu_time();
};

/// Does it, and adds the wall time that it takes to `seconds`.
void timed(double& seconds, const std::function<void()>& work) {
  const double start = wall_time();
  work();
  seconds += wall_time() - start;
}

}  // namespace

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <int d>
RunResult run_with_files(const std::string& name, Simulation<d>& simulation, RunRecord& record,
                         const RunFiles<d>& files, Progress::Style style) {
  const InterruptGuard guard;
  Progress progress(name, style);
  const Stopwatch watch(record);
  const double start = wall_time();
  const long first = simulation.steps.now().step;
  const double before = fraction_done(simulation.control, simulation.steps.now());
  const auto keep = [&] {
    watch.read();
    files.recorder.note(record);
    files.checkpoints->write(simulation, record);
  };
  const auto observe = [&] {
    const Moment now = simulation.steps.now();
    timed(record.writing_s, [&] {
      files.recorder.observe(simulation);
      if (files.checkpoints && files.checkpoints->due(now.time)) keep();
    });
    progress.update(fraction_done(simulation.control, now),
                    fmt::format("t = {:.4g} s, step {}, {:.3g} steps/s", now.time, now.step,
                                static_cast<double>(now.step - first) / (wall_time() - start)),
                    before);
    return !interrupted();
  };
  const RunResult result = run<d>(simulation, observe, record);
  timed(record.writing_s, [&] {
    // before the recorder's last row, which a run that goes on would not have
    if (files.checkpoints && !result.completed()) keep();
    files.recorder.finish(simulation);
  });
  watch.read();
  return result;
}

template RunResult run_with_files<1>(const std::string&, Simulation<1>&, RunRecord&, const RunFiles<1>&,
                                     Progress::Style);
template RunResult run_with_files<2>(const std::string&, Simulation<2>&, RunRecord&, const RunFiles<2>&,
                                     Progress::Style);
template RunResult run_with_files<3>(const std::string&, Simulation<3>&, RunRecord&, const RunFiles<3>&,
                                     Progress::Style);

}  // namespace plumb::app
