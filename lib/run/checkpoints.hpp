#pragma once
#include <filesystem>
#include <optional>

#include "lib/run/checkpoint.hpp"
#include "lib/run/simulation.hpp"

namespace plumb {

/// Seconds that a run took. CPU time counts all threads.
struct Timing {
  double setup = 0;                                    ///< wall time of reading and building [s]
  double wall = 0;                                     ///< wall time of the steps and of writing [s]
  double cpu = 0;                                      ///< CPU time of both [s]
  double writing = 0;                                  ///< wall time of writing [s]
  double computing() const { return wall - writing; }  ///< wall time of the steps alone [s]
};

/// What belongs to a run from its very first step on, and is not in the simulation.
struct RunBook {
  double initial_energy = 0;  ///< total [J]
  Momentum initial_momentum;
  RunHistory history;
  Timing timing;
};

/// The book of a run that begins in this state.
template <int d>
RunBook begin_book(const Simulation<d>& simulation);

/// Puts the simulation into the state of the checkpoint; the book of the run so far. InputError if it does
/// not fit.
template <int d>
RunBook restore(const Checkpoint& checkpoint, Simulation<d>& simulation);

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
  void write(const Simulation<d>& simulation, const RunBook& book, const RecorderMark& recorder);

 private:
  std::filesystem::path file_;
  std::optional<double> interval_;
  std::string program_;
  std::map<std::string, std::string> scene_;
  long next_ = -1;  ///< number of the next multiple; -1 before the first look
};

}  // namespace plumb
