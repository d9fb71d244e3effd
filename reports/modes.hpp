#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/picture.hpp"

namespace plumb::reports {

/// A mode as `plumb spectrum` writes it ("worst"): its particles moved by a third of a spacing at most,
/// coloured by the component that moves most; in 3D the layer that moves most, in 1D
/// the motion across the bar.
Picture mode_picture(const nlohmann::ordered_json& mode, std::string title);

}  // namespace plumb::reports
