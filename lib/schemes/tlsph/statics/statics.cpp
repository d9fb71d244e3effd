#include "lib/schemes/tlsph/statics/statics.hpp"

#include <Eigen/SparseLU>
#include <cmath>
#include <stdexcept>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

using Factor = Eigen::SparseLU<SparseMatrix>;

Eigen::VectorXd part_of(const Eigen::VectorXd& all, const std::vector<Index>& rows) {
  Eigen::VectorXd part(static_cast<Index>(rows.size()));
  for (std::size_t n = 0; n < rows.size(); ++n) part[static_cast<Index>(n)] = all[rows[n]];
  return part;
}

}  // namespace

Eigen::VectorXd equilibrium(const SparseMatrix& stiffness, const Eigen::VectorXd& load,
                            const std::vector<Prescribed>& prescribed) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(stiffness.rows());
  std::vector<Index> held;
  for (const auto& p : prescribed) {
    u[p.unknown] = p.value;
    held.push_back(p.unknown);
  }
  const std::vector<Index> free = free_unknowns(stiffness.rows(), held);
  const Eigen::VectorXd rest = load - stiffness * u;
  Factor factor(part_of(stiffness, free, free));
  if (factor.info() != Eigen::Success)
    throw InputError("no equilibrium", "the stiffness of the free unknowns is singular", "hold the body");
  const Eigen::VectorXd found = factor.solve(part_of(rest, free));
  for (std::size_t n = 0; n < free.size(); ++n) u[free[n]] = found[static_cast<Index>(n)];
  return u;
}

Vibration vibration_near(const Linearised& body, double omega_guess, const Eigen::VectorXd& shape_guess,
                         const std::vector<Index>& held) {
  const std::vector<Index> free = free_unknowns(body.stiffness.rows(), held);
  const SparseMatrix K = part_of(body.stiffness, free, free);
  const Eigen::VectorXd m = part_of(body.mass, free);
  SparseMatrix shifted = K;
  for (Index n = 0; n < m.size(); ++n) shifted.coeffRef(n, n) -= omega_guess * omega_guess * m[n];
  const Factor factor(shifted);
  Eigen::VectorXd x = part_of(shape_guess, free);
  double square = 0, before = -1;
  constexpr int most_steps = 200;
  constexpr double change = 1e-12;  // of the square of the frequency, relative: well below any error studied
  int step = 0;
  for (; step < most_steps && std::abs(square - before) > change * std::abs(square); ++step) {
    const Eigen::VectorXd next = factor.solve(m.cwiseProduct(x));
    x = next / std::sqrt(next.dot(m.cwiseProduct(next)));
    before = square;
    square = x.dot(K * x);
  }
  if (step == most_steps || !(square > 0)) throw std::runtime_error("the vibration was not found");
  Vibration result{std::sqrt(square), Eigen::VectorXd::Zero(body.mass.size())};
  for (std::size_t n = 0; n < free.size(); ++n) result.shape[free[n]] = x[static_cast<Index>(n)];
  return result;
}

}  // namespace plumb
