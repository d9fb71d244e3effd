#include "reports/plot/gnuplot.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <gnuplot-iostream.h>
#pragma GCC diagnostic pop

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

#include "lib/core/error.hpp"

namespace plumb::reports::plot {
namespace {

/// While it lives, a program at the other end of a pipe that ends early does not end us.
class IgnoreBrokenPipe {
 public:
  IgnoreBrokenPipe() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~IgnoreBrokenPipe() { std::signal(SIGPIPE, before_); }
  IgnoreBrokenPipe(const IgnoreBrokenPipe&) = delete;
  IgnoreBrokenPipe& operator=(const IgnoreBrokenPipe&) = delete;

 private:
  void (*before_)(int);
};

bool installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::stringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

std::string first_message(const std::filesystem::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t^") != std::string::npos) return line;
  return "it gave no message";
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "plumb-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw InputError("no temporary folder can be made", name,
                     "Free some space or set TMPDIR to a folder with room.");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void run_gnuplot(const std::string& script, const std::filesystem::path& expected,
                 const TemporaryFolder& folder) {
  if (!installed("gnuplot"))
    throw InputError("no picture can be drawn", "the program gnuplot is not in PATH",
                     "Install it: apt-get install gnuplot-nox.");
  const auto messages = folder.path() / "messages";
  {
    const IgnoreBrokenPipe guard;
    Gnuplot gnuplot("gnuplot 2>'" + messages.string() + "'");
    gnuplot << script << std::flush;
  }
  std::error_code ignored;
  if (std::filesystem::file_size(expected, ignored) > 0 && !ignored) return;
  throw InputError("gnuplot could not draw the picture", first_message(messages),
                   "Look at the data of the picture; version 5.4 or later is needed.");
}

}  // namespace plumb::reports::plot
