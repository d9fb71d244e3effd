#pragma once
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace plumb {

/// While it lives, this process gets no more than so many bytes of memory beyond those that it has: what a
/// damaged file asks a library for is refused at once, instead of taken. Does nothing where the system does
/// not say how much a process has.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) {
    std::size_t pages = 0;  // of virtual memory
    if (!(std::ifstream("/proc/self/statm") >> pages) || ::getrlimit(RLIMIT_AS, &before_) != 0) return;
    rlimit now = before_;
    const rlim_t wanted = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + more;
    if (now.rlim_cur != RLIM_INFINITY && now.rlim_cur <= wanted) return;
    now.rlim_cur = wanted;
    set_ = ::setrlimit(RLIMIT_AS, &now) == 0;
  }
  ~MemoryLimit() {
    if (set_) ::setrlimit(RLIMIT_AS, &before_);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
  bool set_ = false;
};

}  // namespace plumb
