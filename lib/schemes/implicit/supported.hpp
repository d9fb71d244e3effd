#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/schemes/implicit/balance.hpp"
#include "lib/schemes/implicit/tangent_solver.hpp"

namespace plumb {

/// A part of a body that can move as it is.
struct LoosePart {
  std::optional<Index> particle;  ///< its first one; nullopt: the part is the whole body
  std::string
      motion;  ///< "move along x", "turn about (0, 0.5)", "turn about the direction (1, 0, 0) through (0, 0.5, 0)"
};

/// Finds a part with a rigid motion that neither the held unknowns nor images behind walls resist; nullopt if there is none. `energy` is
/// linearised at the reference.
template <int d>
std::optional<LoosePart> loose_part(const DiscreteEnergy<d>& energy, const std::vector<Index>& held);

/// Throws InputError if the body can move without a force: it names the rigid motion that nothing holds, with a particle of the part
/// that is loose. Factors also show a particle that moves in another way, which conjugate gradients do where they do not end.
template <int d>
void require_support(Balance<d>& balance, TangentSolver<d>& solver);

}  // namespace plumb
