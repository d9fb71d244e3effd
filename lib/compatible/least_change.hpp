#pragma once
#include "plumbline/compatible/constraints.hpp"

namespace plumb {

struct LeastChange {
  double start_residual, residual;  ///< largest violation of a constraint, in units of the spacing
  int refinements;
  Index unknowns;
};

/// Moves the table onto its constraints by the least weighted change. The normal matrix is singular (every
/// polynomial of degree 2 is in its null space, and alternating fields on lattices), so it is factorised
/// (CHOLMOD) with a small multiple of the identity added, and the solution refined until the constraints
/// themselves are met to round-off.
template <int d>
LeastChange least_change(AreaTable<d>& table, double volume_weight);

}  // namespace plumb
