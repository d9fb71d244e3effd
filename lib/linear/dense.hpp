#pragma once
#include <Eigen/Core>

namespace plumb {

/// Eigenvalues of a symmetric matrix, ascending, and orthonormal vectors (columns).
struct SymmetricPairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Eigenvalues of any real matrix, and vectors of length 1 (columns). The two of a complex pair follow each other, the one with positive
/// imaginary part first.
struct ComplexPairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

// All of these are LAPACK's. They throw std::runtime_error if an iteration does not converge or memory runs out, InputError if a number of the matrix is not
// finite; a matrix of no rows has no pairs.

/// Finds the eigenpairs of a symmetric matrix, of which the lower half is read.
SymmetricPairs symmetric_pairs(Eigen::MatrixXd matrix);

/// Finds the eigenvalues of a symmetric matrix, ascending; the lower half is read.
Eigen::VectorXd symmetric_values(Eigen::MatrixXd matrix);

/// Finds the eigenpairs of a real matrix.
ComplexPairs complex_pairs(Eigen::MatrixXd matrix);

/// Finds the eigenvalues of a real matrix.
Eigen::VectorXcd complex_values(Eigen::MatrixXd matrix);

/// Gives orthonormal columns that span what the given ones span. A direction that is less than `least` of the longest one is left out.
Eigen::MatrixXd orthonormal_basis(Eigen::MatrixXd columns, double least);

}  // namespace plumb
