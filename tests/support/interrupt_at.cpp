// Preloaded into a program that is to be interrupted: when it gives the n-th file whose name holds a text its
// final name, it is sent SIGINT. So a test of Ctrl-C waits for no clock.
//   PLUMB_TEST_INTERRUPT_AT=kept/ PLUMB_TEST_INTERRUPT_COUNT=1 LD_PRELOAD=.. plumb ..
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

extern "C" int rename(const char* from, const char* to) {
  using Rename = int (*)(const char*, const char*);
  static const auto original = reinterpret_cast<Rename>(dlsym(RTLD_NEXT, "rename"));
  static const char* const name = std::getenv("PLUMB_TEST_INTERRUPT_AT");
  static const char* const count = std::getenv("PLUMB_TEST_INTERRUPT_COUNT");
  static std::atomic<int> left{count ? std::atoi(count) : 0};
  const int result = original(from, to);
  if (result == 0 && name && std::strstr(to, name) && --left == 0) kill(getpid(), SIGINT);
  return result;
}
