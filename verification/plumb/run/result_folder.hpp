#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace plumb::app {

/// The folder that a run writes into, for as long as this lives: a second run is refused. The lock is the
/// system's and dies with the process; it leaves no file. Where the file system has no locks there is none.
class ResultFolder {
 public:
  /// Takes the folder if it is there; makes nothing. InputError if it could not be made or written into, or
  /// if another run writes into it.
  explicit ResultFolder(std::filesystem::path path);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Makes and takes it, and removes what an earlier run left: files that it did not finish and, unless that
  /// run `goes_on`, its series, frames, budget, summary and checkpoint. Files of other names stay.
  void make(bool goes_on);

  std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }
  std::filesystem::path summary() const { return path_ / "summary.json"; }
  std::filesystem::path budget() const { return path_ / "budget.csv"; }
  const std::filesystem::path& path() const { return path_; }

 private:
  void take();

  std::filesystem::path path_;
  int file_ = -1;
};

/// InputError if the folder holds a checkpoint, which a new run would throw away.
void require_no_checkpoint(const std::filesystem::path& folder);

/// The summary that a completed run of these settings left in the folder; nothing if there is none.
/// InputError with the difference if it is one of other settings.
std::optional<nlohmann::ordered_json> completed_summary(const std::filesystem::path& folder,
                                                        const std::map<std::string, std::string>& settings);

}  // namespace plumb::app
