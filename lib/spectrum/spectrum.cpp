#include "plumbline/spectrum/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "plumbline/core/error.hpp"
#include "plumbline/diagnostics/measures.hpp"
#include "plumbline/spectrum/krylov.hpp"

namespace plumb {
namespace {

using Complex = std::complex<double>;
/// Relative to the largest eigenvalue: round-off of eigenvalues of a matrix that is not normal.
constexpr double rounding = 1e-10;

/// Growth of exp(s t) with s^2 = -value.
double growth_of(Complex value) {
  return std::abs(std::sqrt(value).imag());
}

template <int d>
double unexplained_share(const LinearOperator<d>& op, const Eigen::VectorXd& motion) {
  const Solid<d>& solid = op.solid();
  const BondTable<d>& t = solid.bonds;
  State<d> state = make_state(solid);
  for (Index n = 0; n < op.size(); ++n)
    state.u[op.components()[n].axis][t.slots.of(op.components()[n].particle)] =
        motion[n] * solid.cloud.spacing;
  const State<d> rest = make_state(solid);
  std::vector<Mat<d>> H(t.slots.count(), Mat<d>::Zero());
  for (Index p = 0; p < solid.cloud.size(); ++p)
    H[t.slots.of(p)] = deformation_gradient_of(solid, state, p) - deformation_gradient_of(solid, rest, p);
  double left = 0, all = 0;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p), row = t.row[i / t.width], lane = i % t.width;
    for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n) {
      Vec<d> X;
      for (int k = 0; k < d; ++k) X[k] = t.separation[(n * d + k) * t.width + lane];
      // nearest pairs, on jittered clouds too
      if (X.norm() == 0 || X.norm() > 1.1 * solid.cloud.spacing) continue;
      const Index j = i + t.offset[n];
      const Vec<d> u = vector_at<d>(state.u, j) - vector_at<d>(state.u, i);
      left += (u - 0.5 * (H[i] + H[j]) * X).squaredNorm();
      all += u.squaredNorm();
    }
  }
  return all > 0 ? std::sqrt(left / all) : 0.0;
}

/// Rigid motions in the scaled unknowns q = R a, orthonormal.
template <int d>
Eigen::MatrixXd scaled_rigid_motions(const LinearOperator<d>& op, const Eigen::VectorXd& root) {
  Eigen::MatrixXd span = root.asDiagonal() * op.rigid_motions();
  if (span.cols() == 0) return span;
  return Eigen::HouseholderQR<Eigen::MatrixXd>(span).householderQ() *
         Eigen::MatrixXd::Identity(span.rows(), span.cols());
}

/// All eigenpairs of S, moved so that the rigid motions are not among the low ones: adding Q Q^T gives them
/// the value 1 and leaves the others alone, since S Q = 0.
EigenPairs dense_pairs(const Eigen::MatrixXd& S, const Eigen::MatrixXd& rigid, bool symmetric) {
  const Eigen::MatrixXd moved = S + rigid * rigid.transpose();
  EigenPairs pairs;
  if (symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (moved + moved.transpose()));
    pairs.values = solver.eigenvalues().cast<Complex>();
    pairs.vectors = solver.eigenvectors();
  } else {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(moved);
    pairs.values = solver.eigenvalues();
    pairs.vectors = solver.eigenvectors().real();
  }
  return pairs;
}

void drop_rigid(EigenPairs& pairs, const Eigen::MatrixXd& rigid) {
  std::vector<Index> keep;
  for (Index n = 0; n < pairs.values.size(); ++n) {
    const Eigen::VectorXd v = pairs.vectors.col(n).normalized();
    if ((rigid.transpose() * v).norm() < 0.99) keep.push_back(n);
  }
  EigenPairs kept;
  kept.values.resize(static_cast<Index>(keep.size()));
  kept.vectors.resize(pairs.vectors.rows(), static_cast<Index>(keep.size()));
  for (std::size_t n = 0; n < keep.size(); ++n) {
    kept.values[n] = pairs.values[keep[n]];
    kept.vectors.col(n) = pairs.vectors.col(keep[n]);
  }
  pairs = std::move(kept);
}

void count_complex(Spectrum& result, const Eigen::VectorXcd& values) {
  for (Index n = 0; n < values.size(); ++n) {
    if (values[n].imag() > rounding * result.largest)
      ++result.complex_pairs;
    else if (values[n].imag() == 0 && values[n].real() < -rounding * result.largest)
      ++result.negative;
    result.largest_imaginary =
        std::max(result.largest_imaginary, std::abs(values[n].imag()) / result.largest);
    if (std::abs(values[n]) > rounding * result.largest)
      result.growth_undamped = std::max(result.growth_undamped, growth_of(values[n]));
  }
}

/// The lowest pairs as modes.
template <int d>
void take_low(Spectrum& result, const LinearOperator<d>& op, const EigenPairs& pairs,
              const Eigen::VectorXd& root, int wanted) {
  std::vector<Index> order(pairs.values.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<Index>(n);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return pairs.values[a].real() < pairs.values[b].real(); });
  for (const Index n : order) {
    if (static_cast<int>(result.low.size()) == wanted && result.lowest_smooth > 0) break;
    if (result.low.size() > 40u * static_cast<unsigned>(wanted)) break;
    Mode mode;
    mode.value = pairs.values[n].real();
    mode.imaginary = pairs.values[n].imag();
    mode.motion = root.cwiseInverse().asDiagonal() * pairs.vectors.col(n);
    mode.unexplained = unexplained_share(op, mode.motion);
    if (!mode.spurious() && result.lowest_smooth == 0) result.lowest_smooth = mode.value;
    result.low.push_back(std::move(mode));
  }
  if (result.low.empty()) return;
  result.lowest_nonrigid = result.low.front().value;
  for (const auto& mode : result.low) {
    if (!mode.spurious() || !(mode.value < result.lowest_smooth)) continue;
    ++result.spurious_below_smooth;
    if (std::abs(mode.value) < near_zero_share * result.lowest_smooth) ++result.near_zero_not_rigid;
  }
}

/// Fastest growth of a'' = -K a - C a', all eigenvalues of the first-order system.
double damped_growth(const Eigen::MatrixXd& K, const Eigen::MatrixXd& C) {
  const Index n = K.rows();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -K;
  A.bottomRightCorner(n, n) = -C;
  const Eigen::VectorXcd s = Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
  const double largest = s.cwiseAbs().maxCoeff();
  double growth = 0;
  for (Index m = 0; m < s.size(); ++m)
    // rigid motions are double zeros, which rounding splits by its square root
    if (std::abs(s[m]) > 1e-6 * largest) growth = std::max(growth, s[m].real());
  return growth;
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
  const Eigen::VectorXd root = op.root_masses();
  const SparseMatrix S = root.asDiagonal() * K * root.cwiseInverse().asDiagonal();
  result.asymmetry = SparseMatrix(S - SparseMatrix(S.transpose())).norm() / S.norm();
  // a table that is adjoint by construction is symmetric to rounding
  const bool symmetric = result.asymmetry < 1e-11;
  const Eigen::MatrixXd rigid = scaled_rigid_motions(op, root);
  result.rigid = static_cast<int>(rigid.cols());
  result.complete = op.size() <= options.dense_limit;

  EigenPairs pairs;
  if (result.complete) {
    pairs = dense_pairs(S, rigid, symmetric);
    result.largest = pairs.values.cwiseAbs().maxCoeff();
  } else {
    result.largest = std::abs(largest_pairs(S, symmetric, 1).values[0]);
    pairs = lowest_pairs(S, symmetric, result.largest, options.low_modes + result.rigid);
  }
  drop_rigid(pairs, rigid);
  result.rigid_residual = rigid.cols() ? (S * rigid).norm() / result.largest : 0;
  count_complex(result, pairs.values);
  if (!result.complete && !symmetric) count_complex(result, most_imaginary(S, 20));
  take_low(result, op, pairs, root, options.low_modes);
  result.growth = result.growth_undamped;
  if (op.damped()) {
    result.growth_known = 2 * op.size() <= options.dense_limit;
    result.growth = result.growth_known ? damped_growth(K, op.damping_matrix()) : 0;
  }
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

template Spectrum spectrum_of<2>(LinearOperator<2>&, const SpectrumOptions&);
template Spectrum spectrum_of<3>(LinearOperator<3>&, const SpectrumOptions&);
template double largest_eigenvalue<2>(LinearOperator<2>&, double, int);
template double largest_eigenvalue<3>(LinearOperator<3>&, double, int);

}  // namespace plumb
