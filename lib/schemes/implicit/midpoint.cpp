#include "lib/schemes/implicit/midpoint.hpp"

namespace plumb {
template <int d>
Midpoint<d>::Midpoint(StoredEnergy<d> energy, const Actions<d>& actions, double tolerance,
                      const BodyMotion& from, LinearSolver how)
    : tolerance_(tolerance),
      balance_(std::move(energy), actions, {from.time, 1}, from.u),
      solver_(balance_, how),
      mass_(balance_.energy().masses()) {}

template <int d>
NewtonResult Midpoint<d>::step(BodyMotion& motion, double dt) {
  const Eigen::VectorXd &u = motion.u, &v = motion.v;
  Eigen::VectorXd end = u + dt * v;
  balance_.move_to({motion.time + dt, 1});
  balance_.put_held(end);
  balance_.move_to({motion.time + dt / 2, 1});
  balance_.set_inertia(4 / (dt * dt) * mass_, u + dt / 2 * v);
  Eigen::VectorXd middle = 0.5 * (u + end);
  NewtonResult result = newton(balance_, solver_, tolerance_, middle);
  if (!result.converged()) return result;
  const Eigen::VectorXd moved = 2 * (middle - u);
  motion.u += moved;
  motion.v = 2 / dt * moved - v;
  motion.time += dt;
  ++motion.step;
  balance_.energy().commit(motion.u);
  return result;
}

template class Midpoint<1>;
template class Midpoint<2>;
template class Midpoint<3>;

}  // namespace plumb
