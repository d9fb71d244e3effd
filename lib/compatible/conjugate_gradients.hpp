#pragma once
#include "plumbline/compatible/multilevel.hpp"

namespace plumb {

/// x with C W C^T x = r, by conjugate gradients with the V-cycle, until the largest residual is below `goal`,
/// or does not get smaller. Returns the number of iterations. r must not lie along quadratic fields.
template <int d>
int solve_by_iterations(const BondOperator<d>& N, const Multilevel<d>& multilevel, Multipliers<d> r,
                        double goal, Multipliers<d>& x);

}  // namespace plumb
