#pragma once
#include <nlohmann/json_fwd.hpp>

#include "lib/scene/scene.hpp"

namespace plumb::app {

/// The scheme of the scene on the infinite lattice, along the edge, the face diagonal and the space diagonal,
/// at `points` steps up to theta = pi: rows {"direction", "theta", "gradient", "lowest", "largest"}.
/// gradient: the component along the direction over the exact one; the others: eigenvalues (omega d/c_p)^2.
/// THEORY (9.4), (9.5).
nlohmann::ordered_json symbol_rows(const Scene& scene, int points);

}  // namespace plumb::app
