#include "plumbline/schemes/implicit/balance.hpp"

#include <cmath>

#include "plumbline/diagnostics/measures.hpp"

namespace plumb {

template <int d>
Balance<d>::Balance(const Solid<d>& solid, const Actions<d>& actions, const PathPoint& from,
                    const Eigen::VectorXd& u)
    : actions_(actions),
      held_(held_unknowns(actions)),
      energy_(solid, free_unknowns(d * solid.cloud.size(), held_)),
      loads_(energy_.solid().cloud, actions_),
      at_(from),
      start_(u) {
  Eigen::VectorXd gone = Eigen::VectorXd::Zero(u.size());
  plumb::put_held(actions_, from, gone, gone);
  for (const Index n : held_) start_[n] -= gone[n];
  move_to(from.share);
}

template <int d>
void Balance<d>::move_to(double share) {
  at_.share = share;
  dead_ = loads_.dead(at_);
}

template <int d>
Eigen::VectorXd Balance<d>::external(const Eigen::VectorXd& u) const {
  return loads_.follow() ? dead_ + loads_.following(at_, energy_.gradients(u)) : dead_;
}

template <int d>
std::optional<Eigen::VectorXd> Balance<d>::residual(const Eigen::VectorXd& u) {
  auto r = energy_.residual(u);
  if (r) *r -= external(u);
  return r;
}

template <int d>
void Balance<d>::linearise_at(const Eigen::VectorXd& u) {
  energy_.linearise_at(u);
  if (loads_.follow()) following_ = loads_.following_tangent(at_, energy_.gradients(u));
}

template <int d>
SparseMatrix Balance<d>::tangent() {
  if (!loads_.follow()) return energy_.tangent();
  const auto& free = energy_.unknowns();
  return energy_.tangent() - part_of(SparseMatrix(following_ * energy_.operators().gradient), free, free);
}

template <int d>
Eigen::VectorXd Balance<d>::tangent_times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd product = energy_.tangent_times(v);
  if (loads_.follow()) product -= following_ * (energy_.operators().gradient * v);
  return product;
}

template <int d>
double Balance<d>::change_of_potential(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                       double* round_off) {
  // the force of a pressure is a polynomial of second degree along the step: Simpson's rule is exact
  const Eigen::VectorXd step = to - from;
  const double work = loads_.follow()
                          ? (external(from) + 4 * external(0.5 * (from + to)) + external(to)).dot(step) / 6
                          : dead_.dot(step);
  const double before = energy_.energy(from), after = energy_.energy(to);
  constexpr double rounding = 1e-14;  // of sums over particles
  *round_off =
      energy_round_off(energy_.solid()) + rounding * (std::abs(before) + std::abs(after) + std::abs(work));
  return after - before - work;
}

template <int d>
double Balance<d>::force_scale(const Eigen::VectorXd& u, const Eigen::VectorXd& residual) const {
  const Eigen::VectorXd outside = external(u);
  return std::max(outside.norm(), (residual + outside).norm());
}

template <int d>
Eigen::VectorXd Balance<d>::free_part(const Eigen::VectorXd& all) const {
  const auto& free = energy_.unknowns();
  Eigen::VectorXd part(static_cast<Index>(free.size()));
  for (std::size_t n = 0; n < free.size(); ++n) part[static_cast<Index>(n)] = all[free[n]];
  return part;
}

template <int d>
Eigen::VectorXd Balance<d>::whole(const Eigen::VectorXd& free) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(start_.size());
  const auto& unknowns = energy_.unknowns();
  for (std::size_t n = 0; n < unknowns.size(); ++n) all[unknowns[n]] = free[static_cast<Index>(n)];
  return all;
}

template class Balance<2>;
template class Balance<3>;

}  // namespace plumb
