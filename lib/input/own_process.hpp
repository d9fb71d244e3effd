#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace plumb {

/// How much a process may take beyond what this one has.
struct ProcessLimits {
  std::size_t memory;     ///< [bytes]
  unsigned long seconds;  ///< of CPU time
};

/// Makes a text in a process of its own, so that a library that believes a damaged file can neither take this
/// one's memory nor end it. Returns nothing if that process came to no good end: it crashed, threw, or met a limit.
/// Throws std::runtime_error if no process can be started. `make` must not start threads.
std::optional<std::string> made_in_own_process(const std::function<std::string()>& make,
                                               const ProcessLimits& limits);

}  // namespace plumb
