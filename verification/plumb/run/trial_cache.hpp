#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "lib/stability/trial.hpp"

namespace plumb::app {

/// Finished runs in a folder, one small file each, by the content of their scene and bounds and by the build
/// of the program: what has been run is never run again, also after an interrupted study. Safe to use from
/// several threads.
class TrialCache {
 public:
  /// Without a folder nothing is kept.
  explicit TrialCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `content` names the run in full.
  std::optional<Trial> find(const std::string& content) const;
  void keep(const std::string& content, const Trial& trial) const;

 private:
  std::filesystem::path file_of(const std::string& content) const;
  std::filesystem::path folder_;
};

}  // namespace plumb::app
