#include "verification/plumb/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <omp.h>

#include <ctime>
#include <nlohmann/json.hpp>
#include <thread>

#include "verification/plumb/build.hpp"
#include "verification/plumb/code.hpp"
#include "verification/plumb/commit.hpp"

namespace plumb::app {

std::string version() {
  return PLUMB_VERSION;
}

std::string commit_date() {
  return PLUMB_COMMIT_DATE;
}

std::string version_text() {
  return fmt::format("plumb {} (commit {}, {} build, {}, {})", PLUMB_VERSION, PLUMB_COMMIT, PLUMB_BUILD_TYPE,
                     PLUMB_COMPILER, PLUMB_FLAGS);
}

std::string build_identity() {
  return fmt::format("{}, code {}", version_text(), PLUMB_CODE);
}

nlohmann::ordered_json provenance() {
  return {{"commit", PLUMB_COMMIT},
          {"compiler", PLUMB_COMPILER},
          {"flags", PLUMB_FLAGS},
          {"build", PLUMB_BUILD_TYPE},
          {"host_cores", std::thread::hardware_concurrency()},
          {"threads", omp_get_max_threads()},
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))}};
}

}  // namespace plumb::app
