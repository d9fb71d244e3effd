#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/measures/measures.hpp"

namespace plumb {

/// Holds the lengths of the steps that the control allowed: one that was cut at a multiple of the interval counts in full, and
/// the one that was cut at the end not at all, unless it is the only one.
struct StepStatistics {
  double first = 0, least = 0, most = 0, last = 0;  ///< [s]
  void count(double dt);
};

/// Holds what a run remembers from its very first step on, beside the state of the body. A checkpoint keeps it as it is,
/// and a continued run goes on with it: bounds refer to the very first state and the very first step, and files go on
/// with the same bytes.
struct RunRecord {
  StepStatistics dt;
  std::optional<double>
      initial_energy;  ///< total [J]; begin_record() finds it, or run(Simulation&, ..) if a bound needs it
  Momentum initial_momentum;
  double setup_s = 0;               ///< wall time of reading and building, of this part of the run only [s]
  double wall_s = 0;                ///< wall time of the steps and of writing [s]
  double cpu_s = 0;                 ///< CPU time of both, of all threads [s]
  double writing_s = 0;             ///< wall time of writing [s]
  std::int64_t next_row = 0;        ///< number of the next multiple of the output interval
  std::int64_t recorded_step = -1;  ///< the last one in the files; before the first row none
  std::int64_t series_bytes = 0;    ///< length of the series
  std::vector<double> particle_times;  ///< of the particle files [s]

  double computing_s() const { return wall_s - writing_s; }  ///< wall time of the steps alone [s]
};

}  // namespace plumb
