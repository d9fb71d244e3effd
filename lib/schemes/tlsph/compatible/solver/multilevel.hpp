#pragma once
#include "lib/schemes/tlsph/compatible/solver/bond_smoother.hpp"
#include "lib/schemes/tlsph/compatible/solver/coarsest.hpp"
#include "lib/schemes/tlsph/compatible/solver/spline_smoother.hpp"

namespace plumb {

/// An approximate inverse of the normal matrix with fixed volumes: smoothing over the bonds in single
/// precision, then one V-cycle for what is left. Its levels are cubic splines on grids, each of twice the
/// spacing of the one before, whose values and gradients at the particles are l and L. THEORY chapter 11.
template <int d>
struct Multilevel {
  BondSmoother<d> smoother;
  ParticlesByCell<d> by_cell;             ///< of the first grid
  std::vector<SplineSmoother<d>> levels;  ///< from fine to coarse
  Coarsest coarsest;                      ///< solves the last one
};

/// Makes the levels of the V-cycle out of the matrix, down to one that is solved directly.
template <int d>
Multilevel<d> multilevel(const BondOperator<d>& N);

/// Makes what one V-cycle works on.
template <int d>
BondWork<d> work_for(const Multilevel<d>& multilevel);

/// z = approximately N^-1 r. Linear in r, but not symmetric: there is no smoothing after the V-cycle.
template <int d>
void precondition(const BondOperator<d>& N, const Multilevel<d>& multilevel, const Multipliers<d>& r,
                  BondWork<d>& work, Multipliers<d>& z);

}  // namespace plumb
