#include "lib/spectrum/damped_growth.hpp"

#include <cmath>

#include "lib/linear/dense.hpp"
#include "lib/spectrum/arnoldi.hpp"

namespace plumb {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rigid motions are double zeros, which rounding splits by its square root.
constexpr double rounding_of_zero = 1e-6;

double fastest(const Eigen::VectorXcd& rates, double largest) {
  double growth = 0;
  for (const auto& rate : rates)
    if (std::abs(rate) > rounding_of_zero * largest) growth = std::max(growth, rate.real());
  return growth;
}

/// (a, b)' = A (a, b) = (b, -K a - C b), and the motion after a time by the series of the exponential.
template <int d>
class Flow {
 public:
  Flow(LinearOperator<d>& op, const SparseMatrix& K) : op_(op), K_(K) {}

  Index rows() const { return 2 * op_.size(); }
  VectorXd rate(const VectorXd& state) const {
    VectorXd result(rows());
    const VectorXd velocity = state.tail(op_.size());
    result << velocity, -(K_ * state.head(op_.size())) - op_.damping(velocity);
    return result;
  }
  /// The state one `step` later, to rounding.
  VectorXd advanced(const VectorXd& state) const {
    VectorXd sum = state, term = state;
    for (int n = 1; term.norm() > 1e-14 * sum.norm(); ++n) {
      term = (step / n) * rate(term);
      sum += term;
    }
    return sum;
  }
  /// The state all `steps` later.
  VectorXd after(VectorXd state) const {
    for (int n = 0; n < steps; ++n) state = advanced(state);
    return state;
  }

  double step = 0;
  int steps = 0;

 private:
  LinearOperator<d>& op_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> K_;
};

/// About the largest modulus of a rate: growth of a vector over some applications.
template <int d>
double largest_rate(const Flow<d>& flow, double oscillation) {
  VectorXd state = broad_start(flow.rows());
  double largest = oscillation;
  for (int n = 0; n < 30; ++n) {
    const VectorXd next = flow.rate(state);
    largest = std::max(largest, next.norm());
    state = next.normalized();
  }
  return largest;
}

}  // namespace

template <int d>
Growth dense_damped_growth(LinearOperator<d>& op, const SparseMatrix& K) {
  const Index n = K.rows();
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -MatrixXd(K);
  A.bottomRightCorner(n, n) = -MatrixXd(op.damping_matrix());
  const Eigen::VectorXcd rates = complex_values(A);
  return {fastest(rates, rates.cwiseAbs().maxCoeff()), 0};
}

template <int d>
Growth damped_growth(LinearOperator<d>& op, const SparseMatrix& K, double largest) {
  Flow<d> flow(op, K);
  const double oscillation = std::sqrt(largest);
  flow.step = 3 / largest_rate(flow, oscillation);  // the terms of the series stay below exp(3)
  const int most_steps = static_cast<int>(std::ceil(800 / (oscillation * flow.step)));
  VectorXd state = broad_start(flow.rows());
  for (; flow.steps < most_steps && state.norm() < 1e3; ++flow.steps) state = flow.advanced(state);
  const MatrixXd span =
      outer_span({flow.rows(), [&](const VectorXd& v) { return flow.after(v); }}, state.norm() >= 1e3);
  Growth growth{0, arnoldi_resolution / (flow.step * flow.steps)};
  if (span.cols() == 0) return growth;
  const MatrixXd basis = orthonormal_basis(span, 1e-6);
  MatrixXd image(basis.rows(), basis.cols());
  for (Index n = 0; n < basis.cols(); ++n) image.col(n) = flow.rate(basis.col(n));
  growth.rate = fastest(complex_values(basis.transpose() * image), oscillation);
  return growth;
}

template Growth dense_damped_growth<1>(LinearOperator<1>&, const SparseMatrix&);
template Growth dense_damped_growth<2>(LinearOperator<2>&, const SparseMatrix&);
template Growth dense_damped_growth<3>(LinearOperator<3>&, const SparseMatrix&);
template Growth damped_growth<1>(LinearOperator<1>&, const SparseMatrix&, double);
template Growth damped_growth<2>(LinearOperator<2>&, const SparseMatrix&, double);
template Growth damped_growth<3>(LinearOperator<3>&, const SparseMatrix&, double);

}  // namespace plumb
