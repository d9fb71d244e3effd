#pragma once
#include <string>
#include <vector>

#include "lib/input/key_notes.hpp"

namespace plumb::app {

/// Lists the kinds of files of which the keys are known: scene, study, stability-study, path.
std::vector<std::string> known_files();

/// Finds the keys of one kind. Throws InputError that names the nearest kind.
KeyNotes keys_of_file(const std::string& kind);

}  // namespace plumb::app
