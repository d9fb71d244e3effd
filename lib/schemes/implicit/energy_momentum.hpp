#pragma once
#include <functional>
#include <memory>

#include "lib/material/law.hpp"
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {

/// An elastic law at one point.
template <int d>
struct PointLaw {
  std::function<double(const Mat<d>& F)> energy;       ///< W [Pa]
  std::function<Mat<d>(const Mat<d>& F)> first_piola;  ///< P [Pa]
};
/// InputError for a law without energy, or one that feels a superposed rotation ("linear-elastic").
template <int d>
PointLaw<d> objective_law(const LawChoice& law, const Elastic& elastic);

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

  /// Makes one step of dt [s], by iterations with the tangent of the midpoint rule; the motion stays as it
  /// was where they do not converge.
  NewtonResult step(BodyMotion& motion, double dt);
  const DiscreteEnergy<d>& energy() { return balance_.energy(); }

 private:
  /// F at the places of the law, at the beginning of the step and so far at its middle.
  struct Middle;

  double tolerance_;
  std::shared_ptr<Middle> middle_;
  Balance<d> balance_;
  DescentSolver solver_;
  Eigen::VectorXd mass_;  ///< rho V of every unknown [kg]
};

}  // namespace plumb
