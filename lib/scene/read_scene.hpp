#pragma once
#include <map>
#include <string>
#include <vector>

#include "lib/input/document.hpp"
#include "lib/input/key_notes.hpp"
#include "lib/input/scene_error.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {

/// Reads and checks a scene file. `overrides` are "section.key=value" as from --set; a value may be written
/// as in the file or as bare text ("17 MPa", verlet). An override of body.spacing replaces body.particles and
/// the other way round; likewise method.cfl and method.time_step, initial.velocity and initial.spin. Throws
/// SceneError (an InputError): "FILE:LINE: key: problem. Why. Suggestion.".
Scene read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

/// Every setting of the file with its overrides, by dotted key (settings_of in document.hpp): what a
/// checkpoint and a cache compare.
std::map<std::string, std::string> scene_settings(const std::string& path,
                                                  const std::vector<std::string>& overrides = {});

/// Reads and checks a scene that is there as text; `file_name` is for messages.
Scene parse_scene(const std::string& text, const std::string& file_name,
                  const std::vector<std::string>& overrides = {});

/// Reads and checks a scene of which the document has been parsed. `notes`: takes down the keys that are
/// asked for.
Scene scene_of(const TomlValue& document, const std::string& file_name, KeyNotes* notes = nullptr);

}  // namespace plumb
