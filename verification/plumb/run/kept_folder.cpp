#include "verification/plumb/run/kept_folder.hpp"

#include <cstdlib>

namespace plumb::app {

std::filesystem::path kept_folder(const std::string& name) {
  const auto place = [](const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();
  };
  if (const auto cache = place("XDG_CACHE_HOME"); !cache.empty()) return cache / "plumb" / name;
  if (const auto home = place("HOME"); !home.empty()) return home / ".cache" / "plumb" / name;
  return {};
}

std::string kept_folder_text(const std::string& name) {
  return "default: plumb/" + name + " in $XDG_CACHE_HOME or ~/.cache";
}

}  // namespace plumb::app
