#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plumb::reports::run {

/// What a program cost and how it ended. exit_code is 128 + number if a signal ended it.
struct Ended {
  int exit_code = 0;
  double wall_s = 0, cpu_s = 0;
  double peak_rss = 0;  ///< largest memory of the program or of one that it started [bytes]
};

/// Runs `program` with `arguments` in `folder`; what it says on both outputs goes to `messages`.
/// @throws InputError if it cannot be started.
Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::filesystem::path& folder, const std::filesystem::path& messages);

/// The processor and memory of this machine, for people: "AMD EPYC 7B13, 2 cores, 8 GB".
std::string machine();

}  // namespace plumb::reports::run
