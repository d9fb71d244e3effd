#pragma once
#include <string>
#include <string_view>

#include "plumbline/scene/section.hpp"

/// What users ask of scenes that does not exist in them yet, so that a refusal can say so: loads, and time in
/// formulas. Goes away with this file.
namespace plumb {

/// Refuses sections, keys and kinds of boundaries that would be loads: [load], gravity, traction ..
void refuse_loads(const TomlValue& document);

/// What to tell about an unknown name of a formula that means the time; empty for other names.
std::string no_time_yet(std::string_view name);

}  // namespace plumb
