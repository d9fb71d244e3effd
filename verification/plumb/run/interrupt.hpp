#pragma once
#include <csignal>

namespace plumb {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM ask for an orderly end instead of killing the program: long
/// loops look at interrupted(). A second signal kills at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction old_interrupt_, old_terminate_;
};

/// True once a signal has asked for the end.
bool interrupted();

}  // namespace plumb
