#pragma once
#include <algorithm>
#include <vector>

#include "lib/schemes/implicit/balance.hpp"
#include "lib/schemes/implicit/tangent_solver.hpp"

namespace plumb {

/// Why Newton's method did not reach equilibrium.
enum class NewtonEnd {
  converged,
  inverted,      ///< some J is not positive wherever the step goes
  not_a_number,  ///< a force or the tangent is not finite
  unsolved,      ///< conjugate gradients do not end
  stalled        ///< the residual does not fall any more
};

/// What one search for equilibrium did.
struct NewtonResult {
  NewtonEnd end = NewtonEnd::stalled;
  std::vector<double> residuals;  ///< |r|/force scale before each iteration, and at the end
  int shifted = 0;                ///< iterations whose tangent was not positive
  bool converged() const { return end == NewtonEnd::converged; }
  int iterations() const { return std::max(0, static_cast<int>(residuals.size()) - 1); }
};

/// Finds u with r(u) = 0 at the free unknowns, from a u whose held unknowns are where they belong: Newton's
/// method with backtracking on the potential, every J positive on the way. Ends when |r| is `tolerance` of
/// the force scale, or as small as the round-off of u and F makes it. THEORY (15.2), (15.3).
template <int d>
NewtonResult newton(Balance<d>& balance, TangentSolver<d>& solver, double tolerance, Eigen::VectorXd& u);

/// Moves u to the present share: held unknowns to where they are prescribed to be, free ones with them
/// through the stiffness at the old u, so that supports that move do not tear their first layer off. Leaves u
/// as it is and says why if that cannot be done. THEORY (15.4).
template <int d>
NewtonEnd predict(Balance<d>& balance, TangentSolver<d>& solver, Eigen::VectorXd& u);

/// Predicts, then searches; a search that is not made has no residuals.
template <int d>
NewtonResult equilibrium_at(Balance<d>& balance, TangentSolver<d>& solver, double tolerance,
                            Eigen::VectorXd& u);

}  // namespace plumb
