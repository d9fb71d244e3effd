#include "lib/schemes/implicit/newton.hpp"

#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr int most_newton_steps = 40;
constexpr int most_halvings = 12;         // of a step: then its direction is of no use
constexpr double enough_of_slope = 1e-4;  // Armijo's share of the decrease that the slope promises

/// What rounding of u by half a unit leaves of r: |K| |u|.
double round_off_of_residual(const SparseMatrix& K, const Eigen::VectorXd& u) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  return unit * (K.cwiseAbs() * u.cwiseAbs()).norm();
}

/// The point on the way along a step that lowers the potential with every J positive; nullopt if there is
/// none. `inverted` says what the last trial failed of.
template <int d>
std::optional<Eigen::VectorXd> backtracked(Balance<d>& balance, const Eigen::VectorXd& u,
                                           const Eigen::VectorXd& step, double slope, bool& inverted) {
  double share = 1;
  for (int n = 0; n < most_halvings; ++n, share /= 2) {
    const Eigen::VectorXd trial = u + share * step;
    inverted = !balance.residual(trial).has_value();
    if (inverted) continue;
    double round_off = 0;
    const double change = balance.change_of_potential(u, trial, &round_off);
    if (change <= enough_of_slope * share * slope + round_off) return trial;
  }
  return std::nullopt;
}

}  // namespace

template <int d>
NewtonResult newton(Balance<d>& balance, DescentSolver& solver, double tolerance, Eigen::VectorXd& u) {
  NewtonResult result;
  const auto ended = [&](NewtonEnd why) {
    result.end = why;
    return result;
  };
  for (int n = 0;; ++n) {
    const auto all = balance.residual(u);
    if (!all) return ended(NewtonEnd::inverted);
    const Eigen::VectorXd r = balance.free_part(*all);
    const double scale = balance.force_scale(u, *all);
    result.residuals.push_back(scale > 0 ? r.norm() / scale : 0);
    if (!r.allFinite()) return ended(NewtonEnd::not_a_number);
    if (r.norm() <= tolerance * scale) return ended(NewtonEnd::converged);
    if (n == most_newton_steps) return ended(NewtonEnd::stalled);
    balance.linearise_at(u);
    const SparseMatrix K = balance.tangent();
    const double round_off =
        round_off_of_residual(K, balance.free_part(u)) + balance.energy().residual_round_off(u);
    if (r.norm() <= round_off) return ended(NewtonEnd::converged);
    const auto solution = solver.solve(K, -r);
    if (!solution) return ended(NewtonEnd::not_a_number);
    if (solution->shift > 0) ++result.shifted;
    bool inverted = false;
    const auto next = backtracked(balance, u, balance.whole(solution->x), r.dot(solution->x), inverted);
    if (!next) return ended(inverted ? NewtonEnd::inverted : NewtonEnd::stalled);
    u = *next;
  }
}

template <int d>
NewtonEnd predict(Balance<d>& balance, DescentSolver& solver, Eigen::VectorXd& u) {
  Eigen::VectorXd moved = u;
  balance.put_held(moved);
  if (moved == u) return NewtonEnd::converged;
  const auto r = balance.residual(u);
  if (!r) return NewtonEnd::inverted;
  balance.linearise_at(u);
  const Eigen::VectorXd pulled = *r + balance.tangent_times(moved - u);
  const auto solution = solver.solve(balance.tangent(), -balance.free_part(pulled));
  if (!solution) return NewtonEnd::not_a_number;
  moved += balance.whole(solution->x);
  if (!balance.residual(moved)) return NewtonEnd::inverted;
  u = moved;
  return NewtonEnd::converged;
}

template <int d>
NewtonResult equilibrium_at(Balance<d>& balance, DescentSolver& solver, double tolerance,
                            Eigen::VectorXd& u) {
  NewtonResult result;
  result.end = predict(balance, solver, u);
  return result.converged() ? newton(balance, solver, tolerance, u) : result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                          \
  template NewtonResult newton<d>(Balance<d>&, DescentSolver&, double, Eigen::VectorXd&); \
  template NewtonEnd predict<d>(Balance<d>&, DescentSolver&, Eigen::VectorXd&);           \
  template NewtonResult equilibrium_at<d>(Balance<d>&, DescentSolver&, double, Eigen::VectorXd&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
