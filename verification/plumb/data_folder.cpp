#include "verification/plumb/data_folder.hpp"

#include <fmt/format.h>

#include <fstream>

#include "lib/core/error.hpp"
#include "places.hpp"

namespace plumb::app {

std::filesystem::path data_folder(const std::filesystem::path& given) {
  namespace fs = std::filesystem;
  if (!given.empty() && !fs::is_directory(given / "verification"))
    throw InputError(fmt::format("--root: no folder \"{}\"", (given / "verification").string()), "",
                     "Name the folder that holds verification/scenes.");
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share" / "plumbline";
  for (const auto& folder : {given, fs::path("."), installed, fs::path(PLUMBLINE_SOURCE_DIR)})
    if (!folder.empty() && fs::exists(folder / "verification" / "scenes")) return fs::canonical(folder);
  return fs::current_path();
}

std::string what_it_shows(const std::filesystem::path& scene) {
  std::ifstream in(scene);
  constexpr std::string_view mark = "# Shows: ";
  for (std::string line; std::getline(in, line) && line.starts_with('#');)
    if (line.starts_with(mark)) return line.substr(mark.size());
  return "";
}

}  // namespace plumb::app
