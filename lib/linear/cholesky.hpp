#pragma once
#include <Eigen/SparseCore>
#include <memory>

namespace plumb {

/// Factorises symmetric positive definite matrices by CHOLMOD; only the lower triangle is read. CHOLMOD's
/// BLAS, the serial OpenBLAS, takes its work space from a list without a lock, and METIS draws from rand():
/// several threads at once get wrong factors, or other ones from run to run. So one thread at a time is in
/// there (THEORY, Decisions).
class Cholesky {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// Chooses the order of elimination for all matrices with these places of entries.
  void analyse(const Matrix& matrix);
  /// Factorises matrix + shift I; says whether it is positive definite.
  bool factorise(const Matrix& matrix, double shift = 0);
  /// Solves for each column with the last factor.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace plumb
