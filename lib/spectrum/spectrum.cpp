#include "lib/spectrum/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "lib/core/error.hpp"
#include "lib/linear/dense.hpp"
#include "lib/spectrum/krylov.hpp"

namespace plumb {
namespace {

/// Relative to the largest eigenvalue: round-off of eigenvalues of a matrix that is not normal, all at once
/// and by iteration.
constexpr double rounding_dense = 1e-10, rounding_iterated = 1e-7;

/// The operator in the unknowns q = R a, in which it is symmetric if the force has an energy.
struct Scaled {
  Eigen::VectorXd root;
  SparseMatrix S;
  Eigen::MatrixXd rigid;  ///< orthonormal
  double asymmetry;
  bool symmetric;
};

template <int d>
Scaled scaled(const LinearOperator<d>& op, const SparseMatrix& K) {
  Scaled s{op.root_masses(), {}, {}, 0, false};
  s.S = s.root.asDiagonal() * K * s.root.cwiseInverse().asDiagonal();
  s.rigid = s.root.asDiagonal() * op.rigid_motions();
  if (s.rigid.cols() > 0) s.rigid = orthonormal_basis(s.rigid, 0);
  s.asymmetry = SparseMatrix(s.S - SparseMatrix(s.S.transpose())).norm() / s.S.norm();
  // a table that is adjoint by construction is symmetric to rounding
  s.symmetric = s.asymmetry < symmetric_to_rounding;
  return s;
}

/// Growth of exp(s t) with s^2 = -value.
double growth_of(std::complex<double> value) {
  return std::abs(std::sqrt(value).imag());
}

void count_growing(Spectrum& result, const Eigen::VectorXcd& values, bool symmetric) {
  const double rounding = (result.complete ? rounding_dense : rounding_iterated) * result.largest;
  for (const auto& value : values) {
    result.largest_imaginary = std::max(result.largest_imaginary, std::abs(value.imag()) / result.largest);
    const bool pair = std::abs(value.imag()) > rounding, negative = !pair && value.real() < -rounding;
    result.complex_pairs.found += pair && value.imag() > 0;
    result.negative.found += negative;
    if (pair || negative)
      result.growth_undamped.rate = std::max(result.growth_undamped.rate, growth_of(value));
  }
  result.complex_pairs.at_least = !result.complete && !symmetric;
  result.negative.at_least = !result.complete && !symmetric;
}

}  // namespace

template <int d>
Spectrum spectrum_of(LinearOperator<d>& op, const SpectrumOptions& options) {
  Spectrum result;
  result.unknowns = op.size();
  if (op.size() < 3)
    throw InputError("the body has fewer than three free components", "there is nothing to analyse",
                     "use more particles or fewer supports");
  const SparseMatrix K = op.stiffness_matrix();
  const auto [root, S, rigid, asymmetry, symmetric] = scaled(op, K);
  result.asymmetry = asymmetry;
  result.rigid = rigid_modes(op, K);
  result.complete = op.size() <= options.dense_limit;

  EigenPairs pairs;
  double reach = std::numeric_limits<double>::infinity();
  if (result.complete) {
    pairs = dense_pairs(S, rigid, symmetric);
    result.largest = pairs.values.cwiseAbs().maxCoeff();
  } else {
    result.largest = largest_modulus(S, symmetric);
    const int wanted = options.low_modes + static_cast<int>(rigid.cols());
    const LowestMotions low = lowest_motions(S, symmetric, result.largest, wanted);
    const GrowingMotions growing = growing_motions(S, symmetric, result.largest);
    Eigen::MatrixXd span(S.rows(), low.span.cols() + growing.span.cols());
    span << low.span, growing.span;
    pairs = pairs_within(span, S, rigid, symmetric, result.largest);
    reach = low.reach + rounding_iterated * result.largest;
    result.growth_undamped.resolution = symmetric ? 0 : growing.resolution;
  }
  result.rigid_residual = rigid.cols() ? (S * rigid).norm() / result.largest : 0;
  count_growing(result, pairs.values, symmetric);
  result.low = low_modes(op, pairs, root, options.low_modes, reach, result.complete);
  result.growth = result.growth_undamped;
  if (op.damped())
    result.growth = 2 * op.size() <= options.dense_limit ? dense_damped_growth(op, K)
                                                         : damped_growth(op, K, result.largest);
  return result;
}

template <int d>
double largest_eigenvalue(LinearOperator<d>& op, double tolerance, int steps) {
  Eigen::VectorXd a(op.size());
  // a start that holds every mode; its numbers do not matter
  for (Index n = 0; n < op.size(); ++n) a[n] = std::sin(12.9898 * static_cast<double>(n + 1));
  a.normalize();
  const Eigen::VectorXd root = op.root_masses();
  double value = 0;
  for (int step = 0; step < steps; ++step) {
    // Rayleigh quotient in the mass-scaled unknowns: its error is the square of the vector's
    const Eigen::VectorXd Sa = root.asDiagonal() * op.stiffness(root.cwiseInverse().asDiagonal() * a);
    const double next = a.dot(Sa);
    a = Sa / Sa.norm();
    // the last change understates the error by the rate of convergence, about 1/step
    const bool done = step > 10 && std::abs(next - value) * step < tolerance * std::abs(next);
    value = next;
    if (done) break;
  }
  return value;
}

double oscillation_limit(std::string_view integrator) {
  if (integrator == "rk3") return std::sqrt(3.0);
  if (integrator == "verlet") return 2;
  throw InputError("no stability limit is known for integrator \"" + std::string(integrator) + "\"", "",
                   "use rk3 or verlet");
}

template Spectrum spectrum_of<1>(LinearOperator<1>&, const SpectrumOptions&);
template Spectrum spectrum_of<2>(LinearOperator<2>&, const SpectrumOptions&);
template Spectrum spectrum_of<3>(LinearOperator<3>&, const SpectrumOptions&);
template double largest_eigenvalue<1>(LinearOperator<1>&, double, int);
template double largest_eigenvalue<2>(LinearOperator<2>&, double, int);
template double largest_eigenvalue<3>(LinearOperator<3>&, double, int);

}  // namespace plumb
