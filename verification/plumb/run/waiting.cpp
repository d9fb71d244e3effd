#include "verification/plumb/run/waiting.hpp"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace plumb::app {

void let_waiting_threads_sleep(char** arguments) {
  for (const char* chosen : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"})
    if (std::getenv(chosen) != nullptr) return;
  if (omp_get_max_threads() < 2) return;
  std::error_code none;
  const auto program = std::filesystem::canonical("/proc/self/exe", none);
  if (none || ::setenv("OMP_WAIT_POLICY", "passive", 1) != 0) return;
  ::execv(program.c_str(), arguments);  // returns only if it fails: then they turn
}

}  // namespace plumb::app
