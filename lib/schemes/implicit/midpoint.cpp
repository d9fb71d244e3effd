#include "lib/schemes/implicit/midpoint.hpp"

namespace plumb {
namespace {

/// rho V of every unknown [kg].
template <int d>
Eigen::VectorXd masses_of(const DiscreteEnergy<d>& energy) {
  const Cloud<d>& cloud = energy.cloud();
  Eigen::VectorXd mass(d * cloud.size());
  for (Index i = 0; i < cloud.size(); ++i)
    mass.segment<d>(d * i).setConstant(energy.elastic().density * cloud.V[i]);
  return mass;
}

}  // namespace

template <int d>
Midpoint<d>::Midpoint(StoredEnergy<d> energy, const Actions<d>& actions, double tolerance,
                      const BodyMotion& from, LinearSolver how)
    : tolerance_(tolerance),
      balance_(std::move(energy), actions, {from.time, 1}, from.u),
      solver_(balance_, how),
      mass_(masses_of(balance_.energy())) {}

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
