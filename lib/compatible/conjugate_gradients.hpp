#pragma once
#include "plumbline/compatible/multilevel.hpp"
#include "plumbline/compatible/quadratic_fields.hpp"

namespace plumb {

/// x with C W C^T x = r, by conjugate gradients with the V-cycle and the fields of degree 2, until the
/// largest residual is below `goal`, or does not get smaller. Returns the number of iterations. r must have
/// no part in the null space.
template <int d>
int solve_by_iterations(const BondOperator<d>& N, const Multilevel<d>& multilevel,
                        const QuadraticFields<d>& fields, Multipliers<d> r, double goal, Multipliers<d>& x);

}  // namespace plumb
