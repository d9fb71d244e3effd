#include "lib/schemes/implicit/newton.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr int most_newton_steps = 40;
constexpr int most_halvings = 12;         // of a step: then its direction is of no use
constexpr double enough_of_slope = 1e-4;  // Armijo's share of the decrease that the slope promises

/// How exactly a step is asked for whose residual is `now` of the forces: to the square of it, so that Newton's method stays
/// quadratic, and no more exactly than the end asks for.
double tolerance_of_step(double now, double tolerance) {
  constexpr double most = 1e-3;
  return std::clamp(now, std::min(most, 0.1 * tolerance / std::max(now, tolerance)), most);
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
NewtonResult newton(Balance<d>& balance, TangentSolver<d>& solver, double tolerance, Eigen::VectorXd& u) {
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
    solver.linearise_at(balance, u);
    const double round_off = solver.round_off(balance, u) + balance.energy().residual_round_off(u);
    if (r.norm() <= round_off) return ended(NewtonEnd::converged);
    const auto solution = solver.solve(balance, -r, tolerance_of_step(result.residuals.back(), tolerance));
    if (!solution) return ended(solver.most_moved() ? NewtonEnd::unsolved : NewtonEnd::not_a_number);
    if (solution->shifted) ++result.shifted;
    bool inverted = false;
    const auto next = backtracked(balance, u, balance.whole(solution->x), r.dot(solution->x), inverted);
    if (!next) return ended(inverted ? NewtonEnd::inverted : NewtonEnd::stalled);
    u = *next;
  }
}

template <int d>
NewtonEnd predict(Balance<d>& balance, TangentSolver<d>& solver, Eigen::VectorXd& u) {
  Eigen::VectorXd moved = u;
  balance.put_held(moved);
  if (moved == u) return NewtonEnd::converged;
  const auto r = balance.residual(u);
  if (!r) return NewtonEnd::inverted;
  solver.linearise_at(balance, u);
  const Eigen::VectorXd pulled = *r + balance.tangent_times(moved - u);
  constexpr double enough = 1e-6;  // Newton's method does the rest
  const auto solution = solver.solve(balance, -balance.free_part(pulled), enough);
  if (!solution) return solver.most_moved() ? NewtonEnd::unsolved : NewtonEnd::not_a_number;
  moved += balance.whole(solution->x);
  if (!balance.residual(moved)) return NewtonEnd::inverted;
  u = moved;
  return NewtonEnd::converged;
}

template <int d>
NewtonResult equilibrium_at(Balance<d>& balance, TangentSolver<d>& solver, double tolerance,
                            Eigen::VectorXd& u) {
  NewtonResult result;
  result.end = predict(balance, solver, u);
  return result.converged() ? newton(balance, solver, tolerance, u) : result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                             \
  template NewtonResult newton<d>(Balance<d>&, TangentSolver<d>&, double, Eigen::VectorXd&); \
  template NewtonEnd predict<d>(Balance<d>&, TangentSolver<d>&, Eigen::VectorXd&);           \
  template NewtonResult equilibrium_at<d>(Balance<d>&, TangentSolver<d>&, double, Eigen::VectorXd&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
