#pragma once
#include <Eigen/Core>

#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// Eigenvalues, and of each one real motion (columns): the real part of its vector, or the imaginary part for
/// the second one of a complex pair, so that the two span what the pair moves.
struct EigenPairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXd vectors;
};

/// All eigenpairs of S but the rigid motions (orthonormal columns, S rigid = 0).
EigenPairs dense_pairs(const SparseMatrix& S, const Eigen::MatrixXd& rigid, bool symmetric);

/// The eigenpairs of S whose vectors lie in the span of the columns, without the rigid motions. A pair that
/// the span holds twice is found once. What the span holds in part only is left out: the residual of every
/// pair is below 1e-6 of `largest`.
EigenPairs pairs_within(const Eigen::MatrixXd& span, const SparseMatrix& S, const Eigen::MatrixXd& rigid,
                        bool symmetric, double largest);

/// Real and imaginary parts of complex columns, each brought to length 1 before.
Eigen::MatrixXd real_span(const Eigen::MatrixXcd& vectors);

}  // namespace plumb
