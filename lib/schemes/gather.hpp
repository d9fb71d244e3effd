#pragma once
#include <cstdint>

#include "lib/schemes/tlsph/bonds/bond_table.hpp"

/// Loops over the bonds of one pack of slots.
namespace plumb {

/// Calls use(n, j) for every bond of a pack, with the first slot of the others.
template <int d, int W, class Use>
inline void for_bonds(const BondTable<d>& t, Index pack, Use&& use) {
  const std::int32_t row = t.row[static_cast<std::size_t>(pack)];
  const std::int64_t end = t.begin[static_cast<std::size_t>(row) + 1];
  for (std::int64_t n = t.begin[static_cast<std::size_t>(row)]; n < end; ++n)
    use(n, pack * W + t.offset[static_cast<std::size_t>(n)]);
}

/// Vector of a bond from an array of d x width numbers per bond.
template <int d, int W>
inline Vec<d, Pack<W>> bond_vector(const AlignedVector& values, std::int64_t n) {
  Vec<d, Pack<W>> v;
  for (int k = 0; k < d; ++k) v[k] = Pack<W>::load(values.data() + (n * d + k) * W);
  return v;
}
template <int W>
inline Pack<W> bond_number(const AlignedVector& values, std::int64_t n) {
  return Pack<W>::load(values.data() + n * W);
}

/// Loads and stores the vectors or tensors of the W slots from `slot` on.
template <int d, int W>
inline Vec<d, Pack<W>> load_vector(const Field& field, Index slot) {
  Vec<d, Pack<W>> v;
  for (int k = 0; k < d; ++k) v[k] = Pack<W>::load(field[k] + slot);
  return v;
}
template <int d, int W>
inline Mat<d, Pack<W>> load_tensor(const Field& field, Index slot) {
  Mat<d, Pack<W>> A;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) A(a, b) = Pack<W>::load(field[a * d + b] + slot);
  return A;
}
template <int d, int W>
inline void store_vector(const Vec<d, Pack<W>>& v, Field& field, Index slot) {
  for (int k = 0; k < d; ++k) v[k].store(field[k] + slot);
}
template <int d, int W>
inline void store_tensor(const Mat<d, Pack<W>>& A, Field& field, Index slot) {
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) A(a, b).store(field[a * d + b] + slot);
}

/// Multiplies small matrices and vectors entry by entry, in a fixed order of the sums.
template <int d, class T>
inline Vec<d, T> times(const Mat<d, T>& A, const Vec<d, T>& x) {
  Vec<d, T> y;
  for (int a = 0; a < d; ++a) {
    y[a] = A(a, 0) * x[0];
    for (int b = 1; b < d; ++b) y[a] += A(a, b) * x[b];
  }
  return y;
}
template <int d, class T>
inline Vec<d, T> transpose_times(const Mat<d, T>& A, const Vec<d, T>& x) {
  Vec<d, T> y;
  for (int a = 0; a < d; ++a) {
    y[a] = A(0, a) * x[0];
    for (int b = 1; b < d; ++b) y[a] += A(b, a) * x[b];
  }
  return y;
}
template <int d, class T>
inline T dot(const Vec<d, T>& x, const Vec<d, T>& y) {
  T sum = x[0] * y[0];
  for (int a = 1; a < d; ++a) sum += x[a] * y[a];
  return sum;
}
/// A += x (x) y.
template <int d, class T>
inline void add_outer(Mat<d, T>& A, const Vec<d, T>& x, const Vec<d, T>& y) {
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) A(a, b) += x[a] * y[b];
}
template <int d, class T>
inline Mat<d, T> zero_tensor() {
  Mat<d, T> A;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) A(a, b) = T(0);
  return A;
}
template <int d, class T>
inline Vec<d, T> zero_vector() {
  Vec<d, T> v;
  for (int a = 0; a < d; ++a) v[a] = T(0);
  return v;
}

/// Calls use.operator()<W>() with the width of a table's packs.
template <int d, class Use>
void with_width(const BondTable<d>& t, Use&& use) {
  if (t.width == 1)
    use.template operator()<1>();
  else
    use.template operator()<native_width>();
}

}  // namespace plumb
