#include "lib/schemes/tlsph/compatible/solver/spline_rows.hpp"

#include <cmath>

namespace plumb {

template <int d>
std::vector<std::int32_t> rows_by_place(const SplineMatrix<d>& matrix) {
  std::vector<std::int32_t> row(matrix.grid.places, -1);
  for (Index r = 0; r < matrix.rows(); ++r) row[matrix.places[r]] = static_cast<std::int32_t>(r);
  return row;
}

template <int d>
void make_rows(SplineMatrix<d>& matrix, const std::vector<char>& used) {
  for (Index p = 0; p < matrix.grid.places; ++p)
    if (used[p]) matrix.places.push_back(p);
  matrix.entries.assign(matrix.places.size() * row_size<d>, 0.0);
}

template <int d>
void finish(SplineMatrix<d>& matrix) {
  matrix.inverse_diagonal.resize(matrix.rows());
  for (Index r = 0; r < matrix.rows(); ++r) {
    const double own = matrix.row(r)[row_size<d> / 2];
    matrix.inverse_diagonal[r] = own > 0 ? 1 / own : 0;
  }
  Coefficients<d> x(matrix.grid.places, Coefficient<d>::Zero()), y = x;
  std::uint64_t seed = 1;
  for (const Index p : matrix.places) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    x[p][0] = static_cast<double>(seed >> 11) * 0x1p-53 - 0.5;
  }
  for (int round = 0; round < 12; ++round) {
    apply(matrix, x, y);
    double xx = 0, xy = 0;
    for (Index r = 0; r < matrix.rows(); ++r) {
      const Index p = matrix.places[r];
      if (matrix.inverse_diagonal[r] == 0) continue;
      xx += x[p][0] * x[p][0] / matrix.inverse_diagonal[r];
      xy += x[p][0] * y[p][0];
    }
    matrix.largest = xy / xx;
    const double scale = 1 / std::sqrt(xx);
    for (Index r = 0; r < matrix.rows(); ++r)
      x[matrix.places[r]] = scale * matrix.inverse_diagonal[r] * y[matrix.places[r]];
  }
  matrix.largest *= 1.1;  // power iterations approach it from below
}

template <int d>
void apply(const SplineMatrix<d>& matrix, const Coefficients<d>& x, Coefficients<d>& result) {
  constexpr int lines = row_size<d> / row_width;
  const auto offset = line_offsets<d>(matrix.grid);
#pragma omp parallel for schedule(static)
  for (Index r = 0; r < matrix.rows(); ++r) {
    const double* row = matrix.row(r);
    Coefficient<d> even = Coefficient<d>::Zero(), odd = even;
    for (int n = 0; n < lines; ++n, row += row_width) {
      const Coefficient<d>* c = x.data() + matrix.places[r] + offset[n];
      for (int o = 0; o < row_width; ++o) (o % 2 ? odd : even) += row[o] * c[o];
    }
    result[matrix.places[r]] = even + odd;
  }
}

#define PLUMB_INSTANTIATE(d)                                                   \
  template std::vector<std::int32_t> rows_by_place<d>(const SplineMatrix<d>&); \
  template void make_rows<d>(SplineMatrix<d>&, const std::vector<char>&);      \
  template void finish<d>(SplineMatrix<d>&);                                   \
  template void apply<d>(const SplineMatrix<d>&, const Coefficients<d>&, Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
