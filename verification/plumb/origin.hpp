#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// The result with what a reader needs to place it in front: version, command and provenance.
nlohmann::ordered_json with_origin(const nlohmann::ordered_json& result, const std::string& command_line);

}  // namespace plumb
