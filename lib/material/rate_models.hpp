#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/type_list.hpp"
#include "lib/material/johnson_cook.hpp"

namespace plumb {

/// Laws that need the length of a time step: schemes that integrate stress by rates have them, and no other.
using RateModels = TypeList<JohnsonCook>;

/// Names of all laws: those of the catalogue, and those that need rates.
std::vector<std::string> law_names();
/// True if only schemes that integrate stress by rates have that law.
bool needs_rates(std::string_view name);
/// True if particles of that law have a temperature.
bool has_temperature(std::string_view name);

}  // namespace plumb
