#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lib/scene/scene.hpp"

namespace plumb::app {

/// Whether `plumb spectrum` asks the scene's scheme by its own steps: it is not made of the bonds and terms of "tlsph".
bool asked_by_steps(const Scene& scene);

/// What a step of the scene's scheme makes of small disturbances, THEORY (9.8). `at`: checkpoint of a state, "end" for that at
/// the end of the run; empty: the start. InputError if there is no such state, or if it has too many numbers.
nlohmann::ordered_json step_spectrum(const Scene& scene, const std::string& at);

std::string step_spectrum_text(const nlohmann::ordered_json& result);

}  // namespace plumb::app
