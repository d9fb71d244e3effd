#include "lib/linear/known_product.hpp"

#include <vector>

namespace plumb {
namespace {

using Matrix = KnownProduct::Matrix;

/// Column c of left x right into the places of the product; `sum` is zero before and after.
void set_column(const Matrix& left, const Matrix& right, Matrix::StorageIndex c, std::vector<double>& sum,
                Matrix& product) {
  for (Matrix::InnerIterator b(right, c); b; ++b)
    for (Matrix::InnerIterator a(left, b.row()); a; ++a)
      sum[static_cast<std::size_t>(a.row())] += a.value() * b.value();
  for (Matrix::InnerIterator p(product, c); p; ++p) {
    double& total = sum[static_cast<std::size_t>(p.row())];
    p.valueRef() = total;
    total = 0;
  }
}

}  // namespace

const Matrix& KnownProduct::of(const Matrix& left, const Matrix& right) {
  if (product_.rows() == 0) return product_ = left * right;
#pragma omp parallel
  {
    std::vector<double> sum(static_cast<std::size_t>(left.rows()), 0.0);
#pragma omp for schedule(static)
    for (Matrix::StorageIndex c = 0; c < static_cast<Matrix::StorageIndex>(right.cols()); ++c)
      set_column(left, right, c, sum, product_);
  }
  return product_;
}

}  // namespace plumb
