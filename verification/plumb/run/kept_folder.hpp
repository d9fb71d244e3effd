#pragma once
#include <filesystem>
#include <string>

namespace plumb::app {

/// Where the program keeps what it may use again for this user alone: $XDG_CACHE_HOME/plumb/NAME, or
/// ~/.cache/plumb/NAME. Empty if there is neither. Nothing is made.
std::filesystem::path kept_folder(const std::string& name);

/// The same place for the help, which is the same for all users.
std::string kept_folder_text(const std::string& name);

}  // namespace plumb::app
