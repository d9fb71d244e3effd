#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "lib/output/particles.hpp"
#include "lib/output/series.hpp"
#include "lib/run/checkpoint.hpp"
#include "lib/run/probe.hpp"
#include "lib/run/simulation.hpp"

namespace plumb {

/// Writes what the scene's [output] asks for while a run goes on: FOLDER/series.csv and FOLDER/particles.pvd.
/// A state is recorded at each multiple of `every`, where the steps of the run are cut
/// (StepControl::interval). The first and the last state are always recorded. What has been written stays,
/// whatever happens to the run.
template <int d>
class Recorder {
 public:
  /// Makes the folder if something is to be written. `from`: the record of an earlier part of the run,
  /// whose files are continued; null: they are begun anew.
  Recorder(const Output& output, std::filesystem::path folder, const Simulation<d>& simulation,
           const RunRecord* from = nullptr);

  /// Records the state if its time has come. For the run's observer.
  void observe(const Simulation<d>& simulation);
  /// Records the last state of a run unless that has been done, and puts it on the disk.
  void finish(const Simulation<d>& simulation);

  /// Flushes the files to the disk and notes in the record how far they have come.
  void note(RunRecord& record);

  const std::vector<BoundProbe>& probes() const { return probes_; }
  std::vector<std::filesystem::path> files() const;

 private:
  void record(const Simulation<d>& simulation);
  void record_series(const Simulation<d>& simulation);
  std::vector<std::string> columns(const Simulation<d>& simulation) const;

  Output output_;
  std::filesystem::path folder_;
  std::vector<BoundProbe> probes_;
  std::unique_ptr<CsvSeries> series_;
  std::optional<ParticleSeries> particles_;
  long next_ = 0;       ///< number of the next multiple of `every`
  long recorded_ = -1;  ///< step of the last state recorded
};

}  // namespace plumb
