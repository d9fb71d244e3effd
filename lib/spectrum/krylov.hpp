#pragma once
#include <Eigen/Core>

#include "plumbline/solid/linearise.hpp"

namespace plumb {

/// Eigenvalues and the real parts of their vectors (columns).
struct EigenPairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXd vectors;
};

/// The `count` pairs of largest modulus. Throws std::runtime_error if the iteration does not converge.
EigenPairs largest_pairs(const SparseMatrix& S, bool symmetric, int count);

/// The `count` pairs nearest to zero, by shift and invert; `largest` sets the scale of the shift.
EigenPairs lowest_pairs(const SparseMatrix& S, bool symmetric, double largest, int count);

/// The `count` eigenvalues of largest imaginary part, as far as they converged.
Eigen::VectorXcd most_imaginary(const SparseMatrix& S, int count);

}  // namespace plumb
