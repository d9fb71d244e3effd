#pragma once
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {

/// Moves a body in time by the trapezoidal rule, THEORY (15.17): velocities and displacements move by the mean of their rates at both ends
/// of a step. Of second order, and the midpoint rule for linear motion; where that is not linear, it keeps linear momentum, but
/// angular momentum only to the order of the step. Loads are taken at the ends of the step, at their full size.
template <int d>
class Trapezoid {
 public:
  /// The actions must outlive it. It begins at the time of `from`.
  Trapezoid(StoredEnergy<d> energy, const Actions<d>& actions, double tolerance, const BodyMotion& from,
            LinearSolver how = LinearSolver::direct);

  /// Makes one step of dt [s]; the motion stays as it was where the search did not converge.
  NewtonResult step(BodyMotion& motion, double dt);
  const DiscreteEnergy<d>& energy() { return balance_.energy(); }

 private:
  double tolerance_;
  Balance<d> balance_;
  TangentSolver<d> solver_;
  Eigen::VectorXd mass_;  ///< rho V of every unknown [kg]
};

}  // namespace plumb
