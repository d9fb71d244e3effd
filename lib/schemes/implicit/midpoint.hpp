#pragma once
#include "plumbline/schemes/implicit/implicit_options.hpp"
#include "plumbline/schemes/implicit/newton.hpp"

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
  Midpoint(const Solid<d>& solid, const Actions<d>& actions, double tolerance, const State<d>& state);

  /// Makes one step of dt [s]; the state stays as it was where the search did not converge.
  NewtonResult step(State<d>& state, double dt);
  const Solid<d>& solid() { return balance_.energy().solid(); }  ///< as of the last search

 private:
  double tolerance_;
  Balance<d> balance_;
  DescentSolver solver_;
  Eigen::VectorXd mass_;  ///< rho V of every unknown [kg]
};

}  // namespace plumb
