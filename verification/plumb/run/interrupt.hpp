#pragma once
#include <array>
#include <csignal>

namespace plumb::app {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and a lost terminal (SIGHUP) ask for an orderly end instead of
/// killing the program: long loops look at interrupted(). A second signal kills at once. A program that was
/// told to outlive its terminal (nohup) does.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  std::array<struct sigaction, 3> old_;  ///< of `signals`
};

/// True once a signal has asked for the end.
bool interrupted();

/// The exit code of a program that a signal ended in good order: 128 and the signal's number, as a shell says
/// it of one that was killed (130 for Ctrl-C, 143, 129); 1 if there was none.
int interrupt_exit_code();

}  // namespace plumb::app
