#include "lib/schemes/implicit/arc_length.hpp"

#include <Eigen/SparseLU>
#include <algorithm>

#include "lib/core/error.hpp"
#include "lib/schemes/implicit/supported.hpp"

namespace plumb {
namespace {

constexpr int most_corrections = 15;
constexpr double shortest = 1e-3;  // of the step that was asked for

template <int d>
void require_constant(const Actions<d>& actions) {
  const auto refuse = [](const char* why) {
    throw InputError("a path by arc length under these loads or supports", why, "use load steps instead");
  };
  for (const auto& load : actions.surface) {
    if (load.pressure) refuse("a pressure that follows has no potential");
    if (!load.steady) refuse("its parameter is the size of loads that are constant in time");
  }
  for (const auto& load : actions.body_forces)
    if (!load.steady) refuse("its parameter is the size of loads that are constant in time");
  for (const auto& held : actions.held)
    for (const auto& place : held.places) {
      const HeldMotion motion = held.motion(place.at, place.component, 0);
      if (!held.steady || motion.velocity != 0 || motion.displacement.value_or(0) != 0)
        refuse("its supports do not move");
    }
}

}  // namespace

template <int d>
ArcLengthPath<d>::ArcLengthPath(const StoredEnergy<d>& energy, const Actions<d>& actions, double tolerance)
    : actions_(actions),
      tolerance_(tolerance),
      balance_(energy, actions, {0, 0}, Eigen::VectorXd::Zero(d * energy.cloud.size())) {
  require_constant(actions);
  TangentSolver<d> solver(balance_, LinearSolver::direct);
  require_support(balance_, solver);
  point_.u = Eigen::VectorXd::Zero(d * energy.cloud.size());
  const auto without = residual(point_.u, 0), with = residual(point_.u, 1);
  load_ = balance_.free_part(Eigen::VectorXd(*without - *with));
  if (load_.norm() == 0)
    throw InputError("a path by arc length without a load", "there is nothing to follow", "add a load");
}

template <int d>
std::optional<Eigen::VectorXd> ArcLengthPath<d>::residual(const Eigen::VectorXd& u, double load) {
  balance_.move_to({0, load});
  return balance_.residual(u);
}

template <int d>
std::optional<ArcPoint> ArcLengthPath<d>::try_step(double length) {
  using Lu = Eigen::SparseLU<SparseMatrix>;  // K is not positive behind a limit point
  ArcPoint next = point_;
  Eigen::VectorXd gone;  // of the free unknowns, since the last point
  for (next.iterations = 0; next.iterations < most_corrections; ++next.iterations) {
    const auto all = residual(next.u, next.load);
    if (!all) return std::nullopt;
    const Eigen::VectorXd r = balance_.free_part(*all);
    const bool first = next.iterations == 0;
    const double scale = balance_.force_scale(next.u, *all);
    balance_.linearise_at(next.u);
    if (!first &&
        (r.norm() <= tolerance_ * scale || r.norm() <= balance_.energy().residual_round_off(next.u)))
      return next;
    const Lu K(balance_.tangent());
    if (K.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd by_load = K.solve(load_), by_residual = K.solve(Eigen::VectorXd(-r));
    if (!by_load.allFinite() || !by_residual.allFinite()) return std::nullopt;
    double change = 0;  // of the load
    if (first) {
      // on in the direction of the last step, towards more load at the start
      const bool back = last_.size() > 0 && last_.dot(by_load) < 0;
      change = (back ? -1 : 1) * length / by_load.norm();
    } else {
      change = -gone.dot(by_residual) / gone.dot(by_load);  // at right angles to the step
    }
    const Eigen::VectorXd step = by_residual + change * by_load;
    gone = first ? step : Eigen::VectorXd(gone + step);
    next.u += balance_.whole(step);
    next.load += change;
  }
  return std::nullopt;
}

template <int d>
std::optional<ArcPoint> ArcLengthPath<d>::step(double length) {
  for (double now = length; now >= shortest * length; now /= 2) {
    const auto next = try_step(now);
    if (!next) continue;
    last_ = balance_.free_part(Eigen::VectorXd(next->u - point_.u));
    point_ = *next;
    balance_.energy().commit(point_.u);
    return next;
  }
  return std::nullopt;
}

template <int d>
Eigen::VectorXd ArcLengthPath<d>::last_step() const {
  return last_.size() > 0 ? balance_.whole(last_) : Eigen::VectorXd::Zero(point_.u.size());
}

template <int d>
void ArcLengthPath<d>::go_on_from(const ArcPoint& point, const Eigen::VectorXd& last_step) {
  point_ = point;
  last_ = balance_.free_part(last_step);
  if (last_.norm() == 0) last_.resize(0);
}

template <int d>
std::vector<BoundaryForce<d>> ArcLengthPath<d>::reactions() {
  const auto all = residual(point_.u, point_.load);
  return all ? forces_of_supports<d>(actions_, *all) : std::vector<BoundaryForce<d>>();
}

template class ArcLengthPath<1>;
template class ArcLengthPath<2>;
template class ArcLengthPath<3>;

}  // namespace plumb
