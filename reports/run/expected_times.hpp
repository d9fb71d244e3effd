#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumb::reports::run {

/// CPU times of the studies of the last report, for the time that is left of the next one. Studies are known
/// by their names, so that a change of the code keeps them.
class ExpectedTimes {
 public:
  /// Those of a file that save() wrote; none if there is no such file, or it cannot be read.
  explicit ExpectedTimes(std::filesystem::path file);

  /// Sets what is to be done: the names of the studies, and those whose results are stored and cost nothing.
  void plan(const std::vector<std::string>& all, const std::vector<std::string>& stored);
  /// A study has ended, after that CPU time [s] of its own run; nothing is learned from one that failed.
  void finished(const std::string& name, std::optional<double> cpu_s);
  /// Share of the planned work that is done, by the times of the last report; a study that was not there
  /// counts as the mean of those that were. By numbers of studies if none is known.
  double fraction() const;
  /// Writes the times to the file, for the next report. Throws OutputError if that fails.
  void save() const;

 private:
  double weight_of(const std::string& name) const;

  std::filesystem::path file_;
  std::map<std::string, double> seconds_;  ///< of the last report, and of what has ended in this one
  std::map<std::string, double> weights_;  ///< of what is planned, as expected when it was planned
  double done_ = 0, total_ = 0;
};

}  // namespace plumb::reports::run
