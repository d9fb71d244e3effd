#pragma once
#include "lib/schemes/tlsph/compatible/solver/multilevel.hpp"

namespace plumb {

/// The last directions of conjugate gradients, from which they can go on with a residual that was found anew.
template <int d>
struct Direction {
  Multipliers<d> p, Np;
  double pNp;
};
template <int d>
using Directions = std::vector<Direction<d>>;  ///< the latest first

/// x with C W C^T x = r, by conjugate gradients with the V-cycle, until the
/// largest residual is below `goal`, or does not get smaller. Returns the number of iterations. r must have
/// no part in the null space.
template <int d>
int solve_by_iterations(const BondOperator<d>& N, const Multilevel<d>& multilevel, Multipliers<d> r,
                        double goal, Directions<d>& directions, Multipliers<d>& x);

}  // namespace plumb
