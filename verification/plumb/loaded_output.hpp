#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lib/scene/scene.hpp"

namespace plumb::app {

/// The `count` lowest vibrations about a state of the scene's body; `at`: its checkpoint, or "end". InputError for a law with history.
nlohmann::ordered_json loaded_vibrations(const Scene& scene, const std::string& at, int count);

std::string loaded_text(const nlohmann::ordered_json& result);

}  // namespace plumb::app
