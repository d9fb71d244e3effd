#pragma once
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

namespace plumb::app {

/// The result of `plumb explain` as text for people.
void tell(std::ostream& out, const nlohmann::ordered_json& explanation);

}  // namespace plumb::app
