#include "lib/input/own_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>

namespace plumb {
namespace {

void limit(int resource, rlim_t value) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0 || now.rlim_max < value) return;
  now.rlim_cur = value;
  ::setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

void set_limits(const ProcessLimits& limits) {
  std::size_t pages = 0;  // of virtual memory
  if (std::ifstream("/proc/self/statm") >> pages)
    limit(RLIMIT_AS, pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + limits.memory);
  limit(RLIMIT_CPU, limits.seconds);
  limit(RLIMIT_CORE, 0);
}

bool write_all(int end, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(end, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  return true;
}

std::string read_all(int end) {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(end, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

[[noreturn]] void be_child(int end, const std::function<std::string()>& make, const ProcessLimits& limits) {
  const int nowhere = ::open("/dev/null", O_WRONLY);  // for the last words of allocators
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  set_limits(limits);
  bool good = false;
  try {
    good = write_all(end, make());
  } catch (...) {
  }
  ::_exit(good ? 0 : 1);
}

}  // namespace

std::optional<std::string> made_in_own_process(const std::function<std::string()>& make,
                                               const ProcessLimits& limits) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = ::fork();
  if (child == 0) be_child(ends[1], make, limits);
  ::close(ends[1]);
  std::string text = child > 0 ? read_all(ends[0]) : std::string();
  ::close(ends[0]);
  if (child < 0) throw std::runtime_error("no process can be started");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return text;
}

}  // namespace plumb
