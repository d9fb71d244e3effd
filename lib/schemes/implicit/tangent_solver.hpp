#pragma once
#include <memory>
#include <optional>

#include "lib/schemes/implicit/balance.hpp"
#include "lib/schemes/implicit/descent_solver.hpp"
#include "lib/schemes/implicit/linear_solver.hpp"
#include "lib/schemes/implicit/two_level.hpp"

namespace plumb {

/// Returns what rounding of u leaves of a residual whose tangent is K: |K| |u| units.
double product_round_off(const SparseMatrix& K, const Eigen::VectorXd& u);

/// Solves with the tangent of a balance. Where the tangent is not positive, the solution is a
/// direction in which the potential falls.
template <int d>
class TangentSolver {
 public:
  struct Solution {
    Eigen::VectorXd x;
    bool shifted = false;  ///< the tangent is not positive
  };

  /// Throws InputError for conjugate gradients under a pressure that follows.
  TangentSolver(const Balance<d>& balance, LinearSolver how);

  /// Moves the tangent to the displacements u.
  void linearise_at(Balance<d>& balance, const Eigen::VectorXd& u);
  /// Solves K x = b of the free unknowns; iterations end at `tolerance` of |b|, factors give all digits. nullopt: the tangent is
  /// not a number, or iterations do not end.
  std::optional<Solution> solve(Balance<d>& balance, const Eigen::VectorXd& b, double tolerance);
  /// What rounding of u by half a unit leaves of r: |K| |u|, or a bound of it.
  double round_off(const Balance<d>& balance, const Eigen::VectorXd& u) const;

  bool iterates() const { return how_ == LinearSolver::iterative; }
  DescentSolver& factors() { return direct_; }
  /// Returns the particle that moves most in what the last iterations had found when they did not end; nullopt: they ended, or there
  /// were none.
  std::optional<Index> most_moved() const { return most_moved_; }
  long iterations() const { return iterations_; }  ///< of conjugate gradients so far
  int levels() const { return moves_; }            ///< how often the two levels were made anew

 private:
  std::optional<Solution> iterate(Balance<d>& balance, const Eigen::VectorXd& b, double tolerance);

  LinearSolver how_;
  DescentSolver direct_;
  SparseMatrix K_;  ///< for factors
  std::unique_ptr<TwoLevel<d>> levels_;
  long iterations_ = 0;
  int moves_ = 0;
  std::optional<Index> most_moved_;
  double fresh_rate_ = 0;  ///< iterations per digit with levels that have just been made
};

}  // namespace plumb
