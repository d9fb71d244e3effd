#pragma once
#include <filesystem>

namespace plumb {

/// The folder with verification/scenes in it: the one given, the current one, that of the installation, or
/// the source tree that this was built from. Without any, the current one: what needs no scene still works.
/// Throws InputError if the one given has none.
std::filesystem::path data_folder(const std::filesystem::path& given = {});

}  // namespace plumb
