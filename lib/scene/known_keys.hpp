#pragma once
#include <string>
#include <vector>

#include "lib/input/key_notes.hpp"

namespace plumb {

/// Finds every key that a scene may have, by asking the reader of scenes (explored_keys in lib/input).
KeyNotes keys_of_scenes();

/// Finds every key that a study may have. `solutions`: the valid names.
KeyNotes keys_of_studies(const std::vector<std::string>& solutions);

/// Finds every key that the path of a material point may have.
KeyNotes keys_of_paths();

}  // namespace plumb
