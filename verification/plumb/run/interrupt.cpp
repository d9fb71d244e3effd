#include "plumb/run/interrupt.hpp"

namespace plumb {
namespace {

volatile std::sig_atomic_t asked_to_end = 0;

void ask_to_end(int) {
  asked_to_end = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() : old_interrupt_{}, old_terminate_{} {
  asked_to_end = 0;
  struct sigaction action {};
  action.sa_handler = &ask_to_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, &old_interrupt_);
  ::sigaction(SIGTERM, &action, &old_terminate_);
}

InterruptGuard::~InterruptGuard() {
  ::sigaction(SIGINT, &old_interrupt_, nullptr);
  ::sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool interrupted() {
  return asked_to_end != 0;
}

}  // namespace plumb
