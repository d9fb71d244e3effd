#pragma once
#include <filesystem>
#include <string>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::run {

/// Keeps the results of jobs on the disk, by a hash of everything that they depend on: the code that
/// computes, the machine, the arguments and the content of the files that the job reads.
class Store {
 public:
  /// `root` is the folder that arguments and inputs are relative to. `code` names the code that computes, as
  /// a hash of its sources and of how they are built, so that a change of the report alone keeps the results;
  /// without it the bytes of the program count.
  Store(std::filesystem::path folder, std::filesystem::path program, std::filesystem::path root, int threads,
        const std::string& code = {});

  /// The stored result, or a fresh one. A job that fails (exit code other than 0 and 1, or no JSON) or was
  /// interrupted is not kept.
  JobResult get(const Job& job) const;
  /// Whether the result is stored, so that get() costs nothing.
  bool has(const Job& job) const;

 private:
  std::string key(const Job& job) const;
  JobResult compute(const Job& job, JobResult result) const;

  std::filesystem::path folder_, program_, root_;
  int threads_;
  std::string code_;
};

/// The whole content of a file. @throws InputError if it cannot be read.
std::string content_of(const std::filesystem::path& file);

}  // namespace plumb::reports::run
