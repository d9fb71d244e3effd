#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plumbline/schemes/implicit/discrete_energy.hpp"

namespace plumb {

/// Returns the rigid motions of a cloud as displacements, one per column: d translations, then rotations
/// about the axes through the middle of the particles (2D: about z), each of largest displacement 1.
template <int d>
Eigen::MatrixXd rigid_motions(const Cloud<d>& cloud);

/// Names a rigid motion that neither the held unknowns nor images behind walls resist: "move along x", "turn
/// about the axis (1, 0, 0) through (0, 0.5, 0)"; nullopt if there is none. `energy` is linearised at the
/// reference.
template <int d>
std::optional<std::string> free_rigid_motion(const DiscreteEnergy<d>& energy, const std::vector<Index>& held);

}  // namespace plumb
