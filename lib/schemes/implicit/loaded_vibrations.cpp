#include "lib/schemes/implicit/loaded_vibrations.hpp"

#include <cmath>
#include <stdexcept>

#include "lib/core/error.hpp"
#include "lib/linear/cholesky.hpp"
#include "lib/linear/dense.hpp"

namespace plumb {
namespace {

constexpr int most_subspace_steps = 300;
constexpr double enough = 1e-9;  // change of an omega^2 between iterations, relative
constexpr double next_shift =
    1e-6;  // of the mean diagonal, as the least shift of Newton's method; then by tens

/// M^-1/2 K M^-1/2 of the free unknowns, and M^-1/2.
template <int d>
SparseMatrix scaled_stiffness(Balance<d>& balance, const Eigen::VectorXd& u, Eigen::VectorXd& root) {
  const DiscreteEnergy<d>& energy = balance.energy();
  Eigen::VectorXd all(u.size());
  for (Index i = 0; i < energy.cloud().size(); ++i)
    all.segment<d>(d * i).setConstant(1 / std::sqrt(energy.elastic().density * energy.cloud().V[i]));
  root = balance.free_part(all);
  balance.linearise_at(u);
  const SparseMatrix K = balance.tangent();
  return root.asDiagonal() * K * root.asDiagonal();
}

/// Factors of S + shift I with the least shift that makes it positive.
double factorise(const SparseMatrix& S, Cholesky& factors) {
  const double scale = S.diagonal().cwiseAbs().mean();
  factors.analyse(S);
  for (double share = 0; share < 1e3; share = share == 0 ? next_shift : 10 * share)
    if (factors.factorise(S, share * scale)) return share * scale;
  throw std::runtime_error("the stiffness cannot be factorised: it is not a number");
}

/// Columns that no symmetry spares, the same every time.
Eigen::MatrixXd first_columns(Index rows, Index columns) {
  Eigen::MatrixXd X(rows, columns);
  for (Index c = 0; c < columns; ++c)
    for (Index r = 0; r < rows; ++r)
      X(r, c) = std::sin(1.3 * static_cast<double>(r * (c + 1)) + static_cast<double>(c));
  return X;
}

}  // namespace

template <int d>
std::vector<LoadedVibration> vibrations_about(Balance<d>& balance, const Eigen::VectorXd& u, int count) {
  if (!balance.symmetric())
    throw InputError("vibrations under a pressure that follows", "its stiffness is not symmetric",
                     "use a traction in its place");
  if (balance.energy().unknowns().empty())
    throw InputError("vibrations of a body that is held everywhere", "nothing of it can move",
                     "leave out one of its supports");
  Eigen::VectorXd root;
  const SparseMatrix S = scaled_stiffness(balance, u, root);
  const Index columns = std::min<Index>(S.rows(), 2 * count + 8);
  count = std::min<int>(count, static_cast<int>(S.rows()));
  Cholesky factors;
  factorise(S, factors);
  Eigen::MatrixXd X = first_columns(S.rows(), columns);
  Eigen::VectorXd before = Eigen::VectorXd::Constant(columns, 1e300);
  for (int n = 0; n < most_subspace_steps; ++n) {
    X = orthonormal_basis(factors.solve(X), 0);
    const SymmetricPairs ritz = symmetric_pairs(X.transpose() * (S * X));
    X *= ritz.vectors;
    const Eigen::VectorXd& now = ritz.values;
    const double scale = now.cwiseAbs().head(count).maxCoeff();
    if ((now - before).head(count).cwiseAbs().maxCoeff() <= enough * scale) {
      std::vector<LoadedVibration> found;
      for (int k = 0; k < count; ++k) found.push_back({now[k], balance.whole(root.cwiseProduct(X.col(k)))});
      return found;
    }
    before = now;
  }
  throw std::runtime_error("the lowest vibrations did not converge");
}

template std::vector<LoadedVibration> vibrations_about<1>(Balance<1>&, const Eigen::VectorXd&, int);
template std::vector<LoadedVibration> vibrations_about<2>(Balance<2>&, const Eigen::VectorXd&, int);
template std::vector<LoadedVibration> vibrations_about<3>(Balance<3>&, const Eigen::VectorXd&, int);

}  // namespace plumb
