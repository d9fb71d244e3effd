#include "lib/schemes/implicit/balance.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {

template <int d>
Balance<d>::Balance(StoredEnergy<d> energy, const Actions<d>& actions, const PathPoint& from,
                    const Eigen::VectorXd& u)
    : actions_(actions),
      held_(held_unknowns(actions)),
      energy_(std::move(energy), free_unknowns(u.size(), held_)),
      loads_(energy_.cloud(), actions_),
      at_(from),
      start_(u) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(u.size());
  Eigen::VectorXd gone = zero;
  plumb::put_held(actions_, from, zero, gone);
  for (const Index n : held_) start_[n] -= gone[n];
  move_to(from);
}

template <int d>
void Balance<d>::move_to(const PathPoint& at) {
  at_ = at;
  dead_ = loads_.dead(at_);
}

template <int d>
void Balance<d>::set_inertia(Eigen::VectorXd weight, Eigen::VectorXd target) {
  weight_ = std::move(weight);
  target_ = std::move(target);
}

template <int d>
Eigen::VectorXd Balance<d>::external(const Eigen::VectorXd& u) const {
  Eigen::VectorXd force = dead_;
  if (loads_.follow()) force += loads_.following(at_, energy_.particle_gradients(u));
  if (weight_.size() > 0) force -= weight_.cwiseProduct(u - target_);
  return force;
}

template <int d>
std::optional<Eigen::VectorXd> Balance<d>::residual(const Eigen::VectorXd& u) const {
  auto r = energy_.residual(u);
  if (r) *r -= external(u);
  return r;
}

template <int d>
void Balance<d>::linearise_at(const Eigen::VectorXd& u) {
  energy_.linearise_at(u);
  if (loads_.follow()) following_ = loads_.following_tangent(at_, energy_.particle_gradients(u));
}

template <int d>
SparseMatrix Balance<d>::tangent() {
  const auto& free = energy_.unknowns();
  SparseMatrix K = energy_.tangent();
  if (loads_.follow()) K -= part_of(SparseMatrix(following_ * energy_.particle_operator()), free, free);
  if (weight_.size() > 0) K.diagonal() += free_part(weight_);
  return K;
}

template <int d>
Eigen::VectorXd Balance<d>::tangent_times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd product = energy_.tangent_times(v);
  if (loads_.follow()) product -= following_ * energy_.change_of_gradients(v);
  if (weight_.size() > 0) product += weight_.cwiseProduct(v);
  return product;
}

template <int d>
double Balance<d>::change_of_potential(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                       double* round_off) {
  // the forces from outside are polynomials of second degree along the step: Simpson's rule is exact
  const double work = (external(from) + 4 * external(0.5 * (from + to)) + external(to)).dot(to - from) / 6;
  const double before = energy_.energy(from), after = energy_.energy(to);
  constexpr double rounding = 1e-14;  // of sums over particles
  *round_off = energy_.round_off() + rounding * (std::abs(before) + std::abs(after) + std::abs(work));
  return after - before - work;
}

template <int d>
double Balance<d>::force_scale(const Eigen::VectorXd& u, const Eigen::VectorXd& residual) const {
  const Eigen::VectorXd outside = external(u);
  const double internal = (residual + outside).norm();
  if (weight_.size() == 0) return std::max(outside.norm(), internal);
  // loads and inertia apart: of a body that is free they are in balance, and their sum is round-off
  const Eigen::VectorXd inertia = weight_.cwiseProduct(u - target_);
  return std::max({(outside + inertia).norm(), inertia.norm(), internal});
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

template class Balance<1>;
template class Balance<2>;
template class Balance<3>;

}  // namespace plumb
