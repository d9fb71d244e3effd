#pragma once
#include "plumbline/compatible/spline_matrix.hpp"

namespace plumb {

/// An approximate inverse of the normal matrix with fixed volumes: one V-cycle. The finest level are the
/// multipliers of all particles; the others are cubic splines on grids, each of twice the spacing of the one
/// before, whose values and gradients at the particles are l and L. THEORY chapter 11.
template <int d>
struct Multilevel {
  ParticlesByCell<d> by_cell;           ///< of the first grid
  std::vector<SplineMatrix<d>> levels;  ///< from fine to coarse
  Eigen::MatrixXd coarsest_inverse;     ///< pseudo-inverse of the last one's matrix, row by row
};

template <int d>
Multilevel<d> multilevel(const BondOperator<d>& N);

/// z = one V-cycle for N z = r. Linear and symmetric in r.
template <int d>
void precondition(const BondOperator<d>& N, const Multilevel<d>& multilevel, const Multipliers<d>& r,
                  Multipliers<d>& z);

}  // namespace plumb
