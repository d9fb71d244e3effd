#pragma once
#include "lib/schemes/tlsph/compatible/projection_solver.hpp"
#include "lib/schemes/tlsph/compatible/solver/constraints.hpp"

namespace plumb {

/// Says how the constraints were met, and what that cost.
struct LeastChange {
  double start_residual, residual;  ///< largest violation of a constraint, in units of the spacing
  double largest_change;            ///< of an area vector
  int refinements;                  ///< solutions, each for what the ones before left
  int iterations;                   ///< of the conjugate gradients; 0 if direct
  int levels;                       ///< of the V-cycle; 0 if direct
  Index unknowns;
};

/// Moves the table onto its constraints by the least weighted change. The normal matrix is singular (every
/// polynomial of degree 2 is in its null space, and alternating fields on lattices), so it is factorised with
/// a small multiple of the identity added, or iterated on; and the solution is refined until the constraints
/// themselves are met to round-off. X: positions [m].
template <int d>
LeastChange least_change(AreaTable<d>& table, const std::vector<Vec<d>>& X, double volume_weight,
                         ProjectionSolver solver = ProjectionSolver::automatic);

}  // namespace plumb
