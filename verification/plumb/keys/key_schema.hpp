#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lib/input/key_notes.hpp"

namespace plumb::app {

/// Makes a JSON schema (draft 7) out of the keys of a file: editors complete and check the file with it.
nlohmann::ordered_json schema_of(const KeyNotes& notes, const std::string& title);

}  // namespace plumb::app
