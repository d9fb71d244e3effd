#pragma once
#include <Eigen/SparseLU>
#include <memory>
#include <optional>

#include "lib/linear/cholesky.hpp"

namespace plumb {

/// Solves (K + shift I) x = b with the least shift that makes x a direction in which the potential falls:
/// none where K is positive definite. Symmetric matrices by Cholesky, others (a pressure follows the surface)
/// by sparse LU. All matrices of one solver have entries at the same places.
class DescentSolver {
 public:
  explicit DescentSolver(bool symmetric) : symmetric_(symmetric) {}

  struct Solution {
    Eigen::VectorXd x;
    double shift;  ///< [N/m]; 0: K is positive
  };
  /// nullopt if K cannot be used with any shift: it is not a number.
  std::optional<Solution> solve(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& b);
  /// Solves with the factors of the last solution.
  Eigen::VectorXd again(const Eigen::VectorXd& b) const;

 private:
  std::optional<Eigen::VectorXd> try_shift(const Eigen::SparseMatrix<double>& K, double shift,
                                           const Eigen::VectorXd& b);

  using Lu = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

  bool symmetric_;
  Cholesky cholesky_;
  std::unique_ptr<Lu> lu_;
  bool analysed_ = false;
};

}  // namespace plumb
