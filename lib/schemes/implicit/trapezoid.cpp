#include "lib/schemes/implicit/trapezoid.hpp"

namespace plumb {

template <int d>
Trapezoid<d>::Trapezoid(StoredEnergy<d> energy, const Actions<d>& actions, double tolerance,
                        const BodyMotion& from, LinearSolver how)
    : tolerance_(tolerance),
      balance_(std::move(energy), actions, {from.time, 1}, from.u),
      solver_(balance_, how),
      mass_(balance_.energy().masses()) {}

template <int d>
NewtonResult Trapezoid<d>::step(BodyMotion& motion, double dt) {
  const Eigen::VectorXd &u = motion.u, &v = motion.v;
  balance_.move_to({motion.time, 1});
  balance_.set_inertia(Eigen::VectorXd::Zero(u.size()), u);
  const auto r = balance_.residual(u);
  NewtonResult result;
  if (!r) {
    result.end = NewtonEnd::inverted;
    return result;
  }
  const Eigen::VectorXd drift = u + dt * v, target = drift - dt * dt / 4 * r->cwiseQuotient(mass_);
  balance_.move_to({motion.time + dt, 1});
  balance_.set_inertia(4 / (dt * dt) * mass_, target);
  Eigen::VectorXd end = drift;
  balance_.put_held(end);
  result = newton(balance_, solver_, tolerance_, end);
  if (!result.converged()) return result;
  motion.v = 2 / dt * (end - u) - v;
  motion.u = end;
  motion.time += dt;
  ++motion.step;
  balance_.energy().commit(motion.u);
  return result;
}

template class Trapezoid<1>;
template class Trapezoid<2>;
template class Trapezoid<3>;

}  // namespace plumb
