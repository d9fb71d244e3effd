#pragma once
#include <filesystem>
#include <string>

namespace plumb::app {

/// The folder with verification/scenes in it: the one given, the current one, that of the installation, or
/// the source tree that this was built from. Without any, the current one: what needs no scene still works.
/// Throws InputError if the one given has none.
std::filesystem::path data_folder(const std::filesystem::path& given = {});

/// What a scene says of itself behind "# Shows:" in its first lines; empty if it says nothing.
std::string what_it_shows(const std::filesystem::path& scene);

}  // namespace plumb::app
