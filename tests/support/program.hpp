#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::test {

/// What a program did: exit code, standard output, standard error.
struct Outcome {
  int code;
  std::string out, error;
};

/// Runs a shell command; a death by signal is reported as 128 + signal.
inline Outcome run_shell(const std::string& command) {
  const TemporaryFolder folder;
  const auto out = folder / "out", error = folder / "error";
  const int status = std::system(("(" + command + ") >" + out.string() + " 2>" + error.string()).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out),
          content_of(error)};
}

/// Runs `plumb ARGUMENTS`.
inline Outcome run_plumb(const std::string& arguments) {
  return run_shell(PLUMB_EXECUTABLE " " + arguments);
}

/// Runs `plumb-house ARGUMENTS`.
inline Outcome run_house(const std::string& arguments) {
  return run_shell(PLUMB_EXECUTABLE "-house " + arguments);
}

}  // namespace plumb::test
