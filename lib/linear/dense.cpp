#include "lib/linear/dense.hpp"

#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/linear/alone.hpp"

namespace plumb {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

lapack_int as_lapack(Eigen::Index n) {
  return static_cast<lapack_int>(n);
}

/// LAPACK's routines may search for ever in what is not finite.
void require_finite(const MatrixXd& matrix) {
  if (!matrix.allFinite())
    throw InputError("a matrix whose eigenvalues are wanted", "it holds numbers that are not finite",
                     "look at the state that it was made of");
}

void require_done(lapack_int info) {
  if (info > 0) throw std::runtime_error("the eigenvalues of a matrix did not converge");
  if (info < 0) throw std::runtime_error("there was no memory for the work on a dense matrix");
}

VectorXd symmetric(MatrixXd& matrix, char job) {
  require_finite(matrix);
  VectorXd values(matrix.rows());
  if (values.size() == 0) return values;
  const Alone alone;
  const lapack_int n = as_lapack(matrix.rows());
  require_done(LAPACKE_dsyevd(LAPACK_COL_MAJOR, job, 'L', n, matrix.data(), n, values.data()));
  return values;
}

/// The eigenvalues; `vectors`, if there is such a matrix, as LAPACK stores them: real and imaginary parts of a pair side by side.
VectorXcd general(MatrixXd& matrix, MatrixXd* vectors) {
  require_finite(matrix);
  VectorXcd values(matrix.rows());
  if (values.size() == 0) return values;
  VectorXd real(values.size()), imaginary(values.size());
  const Alone alone;
  const lapack_int n = as_lapack(matrix.rows());
  require_done(LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', vectors ? 'V' : 'N', n, matrix.data(), n, real.data(),
                             imaginary.data(), nullptr, 1, vectors ? vectors->data() : nullptr, n));
  values.real() = real;
  values.imag() = imaginary;
  return values;
}

}  // namespace

SymmetricPairs symmetric_pairs(MatrixXd matrix) {
  VectorXd values = symmetric(matrix, 'V');
  return {std::move(values), std::move(matrix)};
}

VectorXd symmetric_values(MatrixXd matrix) {
  return symmetric(matrix, 'N');
}

ComplexPairs complex_pairs(MatrixXd matrix) {
  MatrixXd packed(matrix.rows(), matrix.cols());
  ComplexPairs all{general(matrix, &packed), packed.cast<std::complex<double>>()};
  const std::complex<double> i(0, 1);
  for (Eigen::Index n = 0; n < all.values.size(); ++n) {
    if (!(all.values[n].imag() > 0)) continue;
    all.vectors.col(n) = packed.col(n) + i * packed.col(n + 1);
    all.vectors.col(n + 1) = all.vectors.col(n).conjugate();
  }
  return all;
}

VectorXcd complex_values(MatrixXd matrix) {
  return general(matrix, nullptr);
}

MatrixXd orthonormal_basis(MatrixXd columns, double least) {
  require_finite(columns);
  const Eigen::Index most = std::min(columns.rows(), columns.cols());
  if (most == 0) return {columns.rows(), 0};
  const Alone alone;
  const lapack_int rows = as_lapack(columns.rows());
  std::vector<lapack_int> order(static_cast<std::size_t>(columns.cols()), 0);  // 0: free to move
  VectorXd scales(most);
  require_done(LAPACKE_dgeqp3(LAPACK_COL_MAJOR, rows, as_lapack(columns.cols()), columns.data(), rows,
                              order.data(), scales.data()));
  const VectorXd lengths = columns.diagonal().cwiseAbs();  // descending
  Eigen::Index rank = 0;
  while (rank < most && lengths[rank] > least * lengths[0]) ++rank;
  if (rank == 0) return {columns.rows(), 0};
  require_done(LAPACKE_dorgqr(LAPACK_COL_MAJOR, rows, as_lapack(rank), as_lapack(rank), columns.data(), rows,
                              scales.data()));
  return columns.leftCols(rank);
}

}  // namespace plumb
