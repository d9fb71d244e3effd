#include "lib/schemes/implicit/descent_solver.hpp"

namespace plumb {
namespace {

/// Of the mean entry of the diagonal. The least is far below the softest smooth motion; with the most, x is
/// next to the direction of steepest descent.
constexpr double least_shift = 1e-6, most_shift = 1e3;

}  // namespace

std::optional<Eigen::VectorXd> DescentSolver::try_shift(const Eigen::SparseMatrix<double>& K, double shift,
                                                        const Eigen::VectorXd& b) {
  if (symmetric_) {
    if (!analysed_) cholesky_.analyse(K);
    analysed_ = true;
    if (!cholesky_.factorise(K, shift)) return std::nullopt;
    return cholesky_.solve(b);
  }
  Eigen::SparseMatrix<double> shifted = K;
  if (shift > 0)
    for (Eigen::Index n = 0; n < K.rows(); ++n) shifted.coeffRef(n, n) += shift;
  lu_ = std::make_unique<Lu>(shifted);
  if (lu_->info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd x = lu_->solve(b);
  if (!(b.dot(x) > 0)) return std::nullopt;
  return x;
}

std::optional<DescentSolver::Solution> DescentSolver::solve(const Eigen::SparseMatrix<double>& K,
                                                            const Eigen::VectorXd& b) {
  if (K.rows() == 0) return Solution{b, 0};  // everything is held
  const double scale = K.diagonal().cwiseAbs().mean();
  for (double share = 0; share <= most_shift; share = share == 0 ? least_shift : 10 * share) {
    auto x = try_shift(K, share * scale, b);
    if (x && x->allFinite()) return Solution{std::move(*x), share * scale};
  }
  return std::nullopt;
}

Eigen::VectorXd DescentSolver::again(const Eigen::VectorXd& b) const {
  if (b.size() == 0) return b;
  if (symmetric_) return cholesky_.solve(b);
  return lu_->solve(b);
}

}  // namespace plumb
