#pragma once
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {

/// Moves a body in time by the implicit midpoint rule, THEORY (15.5), (15.6): each step is an equilibrium of
/// energy, loads and inertia. Of second order; linear and angular momentum are exact where nothing acts from
/// outside, and no time step is too long for linear motion. Loads are taken at the middle of the step, at
/// their full size. Dissipation is not carried along.
template <int d>
class Midpoint {
 public:
  /// The actions must outlive it. It begins at the state's time. Throws InputError if the force has no
  /// energy.
  Midpoint(const Solid<d>& solid, const Actions<d>& actions, double tolerance, const State<d>& state)
      : Midpoint(stored_energy(solid), actions, tolerance, motion_of<d>(solid.bonds.slots, state)) {}
  Midpoint(StoredEnergy<d> energy, const Actions<d>& actions, double tolerance, const BodyMotion& from,
           LinearSolver how = LinearSolver::direct);

  /// Makes one step of dt [s]; the motion stays as it was where the search did not converge.
  NewtonResult step(BodyMotion& motion, double dt);
  NewtonResult step(State<d>& state, double dt) {
    BodyMotion motion = motion_of<d>(energy().slots(), state);
    const NewtonResult result = step(motion, dt);
    if (result.converged()) set_motion<d>(energy().slots(), motion, state);
    return result;
  }
  const DiscreteEnergy<d>& energy() { return balance_.energy(); }

 private:
  double tolerance_;
  Balance<d> balance_;
  TangentSolver<d> solver_;
  Eigen::VectorXd mass_;  ///< rho V of every unknown [kg]
};

}  // namespace plumb
