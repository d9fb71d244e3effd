#include "verification/plumb/run/interrupt.hpp"

namespace plumb::app {
namespace {

volatile std::sig_atomic_t asked_to_end = 0;

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

void ask_to_end(int signal) {
  asked_to_end = signal;
}

}  // namespace

InterruptGuard::InterruptGuard() : old_{} {
  asked_to_end = 0;
  struct sigaction action {};
  action.sa_handler = &ask_to_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    ::sigaction(signals[k], nullptr, &old_[k]);
    if (signals[k] == SIGHUP && old_[k].sa_handler == SIG_IGN) continue;
    ::sigaction(signals[k], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &old_[k], nullptr);
}

bool interrupted() {
  return asked_to_end != 0;
}

int interrupt_exit_code() {
  return asked_to_end == 0 ? 1 : 128 + asked_to_end;
}

}  // namespace plumb::app
