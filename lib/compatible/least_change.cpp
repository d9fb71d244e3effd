#include "plumbline/compatible/least_change.hpp"

#include <Eigen/CholmodSupport>

#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

using Factor = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

/// Added to the diagonal, whose entries are of order 1. The smallest eigenvalues that matter belong to cubic
/// fields and are of order (spacing/size)^6, 6e-14 for 160 particles across; a refinement multiplies their
/// part of the residual by shift/(eigenvalue + shift). Rounding may turn a pivot negative: then ten times as
/// much.
constexpr double least_shift = 1e-14, most_shift = 1e-10;
/// Rounding of the sums of some 30 terms of order 1 that make a constraint.
constexpr double round_off = 1e-14;
constexpr int most_refinements = 60;

/// Factorises the matrix with the least shift that works.
void factorise(Factor& factor, const Eigen::SparseMatrix<double>& matrix) {
  factor.analyzePattern(matrix);
  for (double shift = least_shift; shift <= most_shift; shift *= 10) {
    factor.setShift(shift);
    factor.factorize(matrix);
    if (factor.info() == Eigen::Success) return;
  }
  throw InputError("the compatible projection has no solution", "its matrix cannot be factorised",
                   "use a larger beta");
}

/// One right-hand side per column, or all of them in one, particle by particle.
template <int d>
ConstraintValues solve(const Factor& factor, const ConstraintValues& right, bool coupled) {
  if (!coupled) return factor.solve(right);
  const Index n = right.rows() / (d + 1);
  Eigen::VectorXd packed(right.size());
  for (Index i = 0; i < n; ++i)
    for (int c = 0; c < d; ++c)
      packed.segment<d + 1>((i * d + c) * (d + 1)) = right.template block<d + 1, 1>(i * (d + 1), c);
  packed = factor.solve(packed).eval();
  ConstraintValues result(right.rows(), right.cols());
  for (Index i = 0; i < n; ++i)
    for (int c = 0; c < d; ++c)
      result.template block<d + 1, 1>(i * (d + 1), c) = packed.segment<d + 1>((i * d + c) * (d + 1));
  return result;
}

}  // namespace

template <int d>
LeastChange least_change(AreaTable<d>& table, double volume_weight) {
  LeastChange result{};
  Factor factor;
  const auto matrix = normal_matrix(table, volume_weight);
  factorise(factor, matrix);
  result.unknowns = matrix.rows();
  ConstraintValues wrong = missing(table);
  result.start_residual = result.residual = wrong.cwiseAbs().maxCoeff();
  AreaTable<d> best = table;
  while (result.residual > round_off && result.refinements < most_refinements) {
    add_multipliers(table, solve<d>(factor, wrong, volume_weight > 0), volume_weight);
    wrong = missing(table);
    ++result.refinements;
    const double residual = wrong.cwiseAbs().maxCoeff();
    if (!(residual < 10 * result.residual)) break;  // rounding, or no solution
    if (residual < result.residual) best = table;
    result.residual = std::min(residual, result.residual);
  }
  table = std::move(best);
  return result;
}

template LeastChange least_change<1>(AreaTable<1>&, double);
template LeastChange least_change<2>(AreaTable<2>&, double);
template LeastChange least_change<3>(AreaTable<3>&, double);

}  // namespace plumb
