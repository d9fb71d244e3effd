#pragma once
#include <nlohmann/json_fwd.hpp>

#include "plumbline/scene/scene.hpp"
#include "plumbline/spectrum/spectrum.hpp"

namespace plumb {

/// The mode that costs least energy and is not rigid: its eigenvalue, the share of it that neighbouring
/// gradients do not explain, and the motion at every particle, largest entry 1: {"value", "unexplained",
/// "spurious", "spacing", "X", "u"}. Null if the body has no such mode.
template <int d>
nlohmann::ordered_json worst_mode(const Spectrum& spectrum, const LinearOperator<d>& op);

/// The scheme of the scene on the infinite lattice, along the edge, the face diagonal and the space diagonal,
/// at `points` steps up to theta = pi: rows {"direction", "theta", "gradient", "lowest", "largest"}.
/// gradient: the component along the direction over the exact one; the others: eigenvalues (omega d/c_p)^2.
/// THEORY (9.4), (9.5).
nlohmann::ordered_json symbol_rows(const Scene& scene, int points);

}  // namespace plumb
