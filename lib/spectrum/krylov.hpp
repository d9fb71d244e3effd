#pragma once
#include "lib/spectrum/eigen_pairs.hpp"

namespace plumb {

/// The largest modulus of an eigenvalue. Throws std::runtime_error if the iteration does not converge.
double largest_modulus(const SparseMatrix& S, bool symmetric);

/// Motions with the eigenvalues nearest to zero.
struct LowestMotions {
  Eigen::MatrixXd span;
  double reach;  ///< no other eigenvalue has a smaller modulus than this
};

/// At least `count` of them, by shift and invert; `largest` sets the scale of the shift. Throws
/// std::runtime_error if the iteration does not converge.
LowestMotions lowest_motions(const SparseMatrix& S, bool symmetric, double largest, int count);

/// Motions of a'' = -S a that grow.
struct GrowingMotions {
  Eigen::MatrixXd span;  ///< of the fastest ones; no columns if there are none
  double resolution;     ///< slower growth [c_p/d] may be missing
};

/// The fastest ones, by Arnoldi's method on the motion after many steps. THEORY (9.6). Throws
/// std::runtime_error if there is growth and the iteration does not converge.
GrowingMotions growing_motions(const SparseMatrix& S, bool symmetric, double largest);

}  // namespace plumb
