#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/schemes/implicit/balance.hpp"
#include "lib/schemes/implicit/tangent_solver.hpp"

namespace plumb {

/// Names a rigid motion that neither the held unknowns nor images behind walls resist: "move along x", "turn
/// about (0, 0.5)", "turn about the direction (1, 0, 0) through (0, 0.5, 0)"; nullopt if there is none.
/// `energy` is linearised at the reference.
template <int d>
std::optional<std::string> free_rigid_motion(const DiscreteEnergy<d>& energy, const std::vector<Index>& held);

/// Throws InputError if the body can move without a force: it names the rigid motion that nothing holds, or a
/// particle of a part that is loose.
template <int d>
void require_support(Balance<d>& balance, TangentSolver<d>& solver);

}  // namespace plumb
