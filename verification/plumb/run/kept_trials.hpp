#pragma once
#include <optional>
#include <string>

#include "lib/output/result_store.hpp"
#include "lib/stability/trial.hpp"

namespace plumb::app {

/// Finds a finished run; nullopt if none was kept. `content` names its scene, its bounds and the build of the program in
/// full: what has been run is never run again, also after an interrupted study.
std::optional<Trial> find_trial(const ResultStore& store, const std::string& content);
/// Keeps a finished run under its content.
void keep_trial(const ResultStore& store, const std::string& content, const Trial& trial);

}  // namespace plumb::app
