#pragma once
#include <Eigen/SparseCore>

namespace plumb {

/// The product of two sparse matrices whose places of entries stay the same while their values change: the
/// places of the product are found once. Columns are summed one by one in a fixed order, so that the bits do
/// not depend on the number of threads.
class KnownProduct {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Returns left x right. The first call finds the places; all others must have the same.
  const Matrix& of(const Matrix& left, const Matrix& right);

 private:
  Matrix product_;
};

}  // namespace plumb
