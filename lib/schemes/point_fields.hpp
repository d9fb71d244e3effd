#pragma once
#include "lib/core/field.hpp"

namespace plumb {

/// Reads and writes one tensor of a field, row by row.
template <int d>
Mat<d> tensor_at(const Field& field, Index i) {
  Mat<d> A;
  for (int n = 0; n < d * d; ++n) A(n / d, n % d) = field[n][i];
  return A;
}
template <int d>
void set_tensor(Field& field, Index i, const Mat<d>& A) {
  for (int n = 0; n < d * d; ++n) field[n][i] = A(n / d, n % d);
}

}  // namespace plumb
