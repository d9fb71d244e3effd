#include "lib/spectrum/eigen_pairs.hpp"

#include <complex>

#include "lib/linear/dense.hpp"

namespace plumb {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

/// Columns that are this near to the span of others add nothing: vectors converge to some 1e-8.
constexpr double same_direction = 1e-6;
/// Relative to the largest eigenvalue. Converged pairs have some 1e-10, parts of others some 1e-2.
constexpr double converged = 1e-6;

MatrixXd real_vectors(const VectorXcd& values, const MatrixXcd& vectors) {
  MatrixXd real(vectors.rows(), vectors.cols());
  for (Eigen::Index n = 0; n < values.size(); ++n) {
    const bool second = values[n].imag() < 0;
    real.col(n) = second ? MatrixXd(vectors.col(n).imag()) : MatrixXd(vectors.col(n).real());
  }
  return real;
}

ComplexPairs all_pairs(const MatrixXd& matrix, bool symmetric) {
  if (!symmetric) return complex_pairs(matrix);
  const SymmetricPairs real = symmetric_pairs(0.5 * (matrix + matrix.transpose()));
  return {real.values.cast<std::complex<double>>(), real.vectors.cast<std::complex<double>>()};
}

/// Those pairs for which keep(n) holds.
template <class Keep>
EigenPairs kept(const ComplexPairs& all, Keep&& keep) {
  std::vector<Eigen::Index> places;
  for (Eigen::Index n = 0; n < all.values.size(); ++n)
    if (keep(n)) places.push_back(n);
  const VectorXcd values = all.values(places);
  return {values, real_vectors(values, all.vectors(Eigen::all, places))};
}

/// An orthonormal basis of the part of the span that is normal to the rigid motions.
MatrixXd basis_of(MatrixXd span, const MatrixXd& rigid) {
  if (rigid.cols() > 0) span -= rigid * (rigid.transpose() * span);
  return orthonormal_basis(std::move(span), same_direction);
}

}  // namespace

MatrixXd real_span(const MatrixXcd& vectors) {
  MatrixXd span(vectors.rows(), 2 * vectors.cols());
  for (Eigen::Index n = 0; n < vectors.cols(); ++n) {
    const Eigen::VectorXcd vector = vectors.col(n).normalized();
    span.col(2 * n) = vector.real();
    span.col(2 * n + 1) = vector.imag();
  }
  return span;
}

EigenPairs dense_pairs(const SparseMatrix& S, const MatrixXd& rigid, bool symmetric) {
  // adding rigid rigid^T gives the rigid motions the value 1, which takes them away from the low ones, and
  // leaves the other eigenvalues alone
  const ComplexPairs all = all_pairs(MatrixXd(S) + rigid * rigid.transpose(), symmetric);
  return kept(all, [&](Eigen::Index n) {
    return (rigid.transpose() * all.vectors.col(n)).norm() < 0.99 * all.vectors.col(n).norm();
  });
}

EigenPairs pairs_within(const MatrixXd& span, const SparseMatrix& S, const MatrixXd& rigid, bool symmetric,
                        double largest) {
  const MatrixXd basis = basis_of(span, rigid);
  const MatrixXd image = S * basis;
  ComplexPairs all = all_pairs(basis.transpose() * image, symmetric);
  MatrixXcd residual = image * all.vectors - basis * all.vectors * all.values.asDiagonal();
  if (rigid.cols() > 0) residual -= rigid * (rigid.transpose() * residual);  // S moves motions by rigid ones
  all.vectors = (basis * all.vectors).eval();
  return kept(all, [&](Eigen::Index n) {
    return residual.col(n).norm() < converged * largest * all.vectors.col(n).norm();
  });
}

}  // namespace plumb
