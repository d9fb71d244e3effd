#pragma once
#include <nlohmann/json.hpp>
#include <optional>

namespace plumb::app {

/// The value, or null.
inline nlohmann::ordered_json optional_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace plumb::app
