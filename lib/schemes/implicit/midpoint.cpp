#include "plumbline/schemes/implicit/midpoint.hpp"

namespace plumb {

template <int d>
Midpoint<d>::Midpoint(const Solid<d>& solid, const Actions<d>& actions, double tolerance,
                      const State<d>& state)
    : tolerance_(tolerance),
      balance_(solid, actions, {state.time, 1}, unknowns_of(solid, state.u)),
      solver_(balance_.symmetric()),
      mass_(masses_of(solid)) {}

template <int d>
NewtonResult Midpoint<d>::step(State<d>& state, double dt) {
  const Eigen::VectorXd u = unknowns_of(solid(), state.u), v = unknowns_of(solid(), state.v);
  Eigen::VectorXd end = u + dt * v;
  balance_.move_to({state.time + dt, 1});
  balance_.put_held(end);
  balance_.move_to({state.time + dt / 2, 1});
  balance_.set_inertia(4 / (dt * dt) * mass_, u + dt / 2 * v);
  Eigen::VectorXd middle = 0.5 * (u + end);
  NewtonResult result = newton(balance_, solver_, tolerance_, middle);
  if (!result.converged()) return result;
  const Eigen::VectorXd moved = 2 * (middle - u);
  set_unknowns(solid(), u + moved, state.u);
  set_unknowns(solid(), 2 / dt * moved - v, state.v);
  state.time += dt;
  ++state.step;
  return result;
}

template class Midpoint<2>;
template class Midpoint<3>;

}  // namespace plumb
