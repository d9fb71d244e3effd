#pragma once
#include <filesystem>
#include <optional>

#include "lib/run/checkpoint.hpp"
#include "lib/run/simulation.hpp"

namespace plumb {

/// Begins the record of a run that starts in this state.
template <int d>
RunRecord begin_record(const Simulation<d>& simulation);

/// Puts the simulation into the state of the checkpoint and returns the record of the run so far. InputError if it does
/// not fit.
template <int d>
RunRecord restore(const Checkpoint& checkpoint, Simulation<d>& simulation);

/// Writes one file over and over: at every interval of simulated time, and when told to.
template <int d>
class Checkpoints {
 public:
  Checkpoints(std::filesystem::path file, std::optional<double> interval, std::string program,
              std::map<std::string, std::string> scene);

  /// True at the first step at or after each multiple of the interval, once.
  bool due(double time);
  /// Replaces the file by the run as it stands. Throws OutputError that names the one before, which is kept.
  /// A state that is not finite is not written: the last good one stays.
  void write(const Simulation<d>& simulation, const RunRecord& record);

 private:
  std::filesystem::path file_;
  std::optional<double> interval_;
  std::string program_;
  std::map<std::string, std::string> scene_;
  long next_ = -1;  ///< number of the next multiple; -1 before the first look
};

}  // namespace plumb
