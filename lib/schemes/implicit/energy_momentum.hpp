#pragma once
#include <memory>

#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/newton.hpp"
#include "lib/schemes/implicit/step_stress.hpp"

namespace plumb {

/// Moves a body in time by the midpoint rule with a stress that is corrected so that the work of a step is
/// the change of the energy, THEORY (15.12), (15.13). Of second order; linear momentum, angular momentum and
/// energy are exact where nothing acts from outside. The correction is a symmetric second Piola-Kirchhoff
/// stress, so that it has no torque. Loads are taken at the middle of the step.
template <int d>
class EnergyMomentum {
 public:
  /// The actions must outlive it. It begins at the time of `from`.
  EnergyMomentum(const StoredEnergy<d>& energy, PointLaw<d> law, const Actions<d>& actions, double tolerance,
                 const BodyMotion& from);

  /// Makes one step of dt [s], by iterations with the symmetric tangent of the midpoint rule, and with the
  /// exact one of the step as soon as an iteration gains less than a digit. The motion stays as it was where they do not converge.
  NewtonResult step(BodyMotion& motion, double dt);
  const DiscreteEnergy<d>& energy() { return balance_.energy(); }

 private:
  /// F at the places of the law, at the beginning of the step and so far at its middle.
  struct Middle;

  double tolerance_;
  std::shared_ptr<Middle> middle_;
  Balance<d> balance_;
  DescentSolver solver_, exact_solver_;
  Eigen::VectorXd mass_;  ///< rho V of every unknown [kg]
};

}  // namespace plumb
