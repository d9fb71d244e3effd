#pragma once
#include "lib/actions/actions.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"

/// Applies what acts from outside to a total Lagrangian body, THEORY (5.7), (5.8).
namespace plumb {

/// Adds the loads and then the supports to a body, as its last terms "loads" and "supports"; what is absent
/// adds no term. A held component has the force rho times its prescribed acceleration. If two boundaries hold
/// a component, the later one wins.
template <int d>
void apply_actions(Solid<d>& solid, const Actions<d>& actions);

/// Gives held components the velocity of the state's time, and the displacement where it is prescribed.
/// `all`: those that never change their velocity, too (at the start of a run).
template <int d>
void impose(const Solid<d>& solid, const Actions<d>& actions, State<d>& state, bool all = true);

/// Returns the integrator that after each step puts held components where they are prescribed to be; the same
/// one if none of them changes its velocity.
template <int d>
ChosenIntegrator<d> with_prescribed_motion(ChosenIntegrator<d> integrator, const Actions<d>& actions);

}  // namespace plumb
