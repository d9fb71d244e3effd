#include "lib/schemes/implicit/tangent_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/core/error.hpp"
#include "lib/linear/conjugate_gradients.hpp"

namespace plumb {
namespace {

constexpr int most_iterations = 3000;
/// Iterations per digit, against those with new levels, after which levels are made anew.
constexpr double worn = 1.5;

}  // namespace

template <int d>
TangentSolver<d>::TangentSolver(const Balance<d>& balance, LinearSolver how)
    : how_(how), direct_(balance.symmetric()) {
  if (iterates() && !balance.symmetric())
    throw InputError("a pressure that follows under [implicit] solver = \"iterative\"",
                     "its tangent is not symmetric, and conjugate gradients need that",
                     "use solver = \"direct\", or a traction in its place");
}

template <int d>
void TangentSolver<d>::linearise_at(Balance<d>& balance, const Eigen::VectorXd& u) {
  balance.linearise_at(u);
  if (!iterates()) K_ = balance.tangent();
}

template <int d>
std::optional<typename TangentSolver<d>::Solution> TangentSolver<d>::solve(Balance<d>& balance,
                                                                           const Eigen::VectorXd& b,
                                                                           double tolerance) {
  if (b.size() == 0) return Solution{b};
  if (iterates()) return iterate(balance, b, tolerance);
  auto found = direct_.solve(K_, b);
  if (!found) return std::nullopt;
  return Solution{std::move(found->x), found->shift > 0};
}

template <int d>
std::optional<typename TangentSolver<d>::Solution> TangentSolver<d>::iterate(Balance<d>& balance,
                                                                             const Eigen::VectorXd& b,
                                                                             double tolerance) {
  const DiscreteEnergy<d>& energy = balance.energy();
  if (!b.allFinite()) return std::nullopt;
  const auto K = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    return balance.free_part(balance.tangent_times(balance.whole(v)));
  };
  most_moved_.reset();
  bool fresh = false;
  const auto make_levels = [&] {
    if (!levels_)
      levels_ = std::make_unique<TwoLevel<d>>(energy.cloud(), energy.operators(), energy.unknowns());
    levels_->move_to(energy.material(), balance.inertia(), K);
    ++moves_;
    fresh = true;
  };
  if (!levels_) make_levels();
  for (;;) {
    // with worn levels it is not worth while to go on for long
    const double digits = -std::log10(std::min(tolerance, 0.1));
    const int most = fresh ? most_iterations : static_cast<int>(worn * fresh_rate_ * digits) + 10;
    Conjugated found = conjugate_gradients(
        K, [&](const Eigen::VectorXd& r) { return (*levels_)(K, r); }, b, tolerance, most);
    iterations_ += found.iterations;
    if (!found.x.allFinite()) return std::nullopt;
    if (found.converged && fresh) fresh_rate_ = found.iterations / digits;
    if (found.converged || (found.indefinite && fresh)) return Solution{std::move(found.x), found.indefinite};
    if (fresh) {
      Index most = 0;
      found.x.cwiseAbs().maxCoeff(&most);
      most_moved_ = energy.unknowns()[static_cast<std::size_t>(most)] / d;
      return std::nullopt;
    }
    make_levels();
  }
}

double product_round_off(const SparseMatrix& K, const Eigen::VectorXd& u) {
  return std::numeric_limits<double>::epsilon() * (K.cwiseAbs() * u.cwiseAbs()).norm();
}

template <int d>
double TangentSolver<d>::round_off(const Balance<d>& balance, const Eigen::VectorXd& u) const {
  if (iterates()) return std::numeric_limits<double>::epsilon() * balance.energy().largest_products(u).norm();
  return product_round_off(K_, balance.free_part(u));
}

template class TangentSolver<1>;
template class TangentSolver<2>;
template class TangentSolver<3>;

}  // namespace plumb
