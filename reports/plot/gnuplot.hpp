#pragma once
#include <filesystem>
#include <string>

namespace plumb::reports::plot {

/// A directory of its own for temporary files, removed at the end of its life.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Sends `script` to gnuplot and waits for it. `folder` holds its messages.
/// @throws InputError if gnuplot is not installed, or if it did not make `expected` (with its first message).
void run_gnuplot(const std::string& script, const std::filesystem::path& expected,
                 const TemporaryFolder& folder);

}  // namespace plumb::reports::plot
