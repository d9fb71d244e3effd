#pragma once
#include "lib/schemes/tlsph/compatible/solver/particles_by_cell.hpp"

namespace plumb {

/// Number of places within reach along all axes: the entries of a row.
template <int d>
inline constexpr int row_size = d == 1   ? 9
                                : d == 2 ? 81
                                         : 729;

/// From a row's place to the first entry of each line of its columns, lines along axis 0.
template <int d>
std::array<Index, row_size<d> / 9> line_offsets(const SplineGrid<d>& grid) {
  constexpr int width = 2 * spline_reach + 1;
  std::array<Index, row_size<d> / width> offset;
  for (int n = 0; n < row_size<d> / width; ++n) {
    offset[n] = -spline_reach;
    for (int k = 1, rest = n; k < d; ++k, rest /= width)
      offset[n] += (rest % width - spline_reach) * grid.stride[k];
  }
  return offset;
}

/// The normal matrix on spline fields, P^T C W C^T P: rows for the splines that some particle sees, entries
/// by the offset of the other spline, axis 0 fastest. One matrix serves all components.
template <int d>
struct SplineMatrix {
  SplineGrid<d> grid;
  std::vector<Index> places;             ///< of the rows
  std::vector<double> entries;           ///< per row: row_size
  std::vector<double> inverse_diagonal;  ///< per row
  double largest = 0;                    ///< bound of the eigenvalues of (diagonal)^-1 matrix

  Index rows() const { return static_cast<Index>(places.size()); }
  const double* row(Index r) const { return entries.data() + r * row_size<d>; }
  double* row(Index r) { return entries.data() + r * row_size<d>; }
};

/// The matrix on the finest grid, whose spacing must not be below the reach of the bonds.
template <int d>
SplineMatrix<d> spline_matrix(const BondOperator<d>& N, const SplineGrid<d>& grid,
                              const ParticlesByCell<d>& by_cell);

/// Makes the matrix on splines of twice the spacing.
template <int d>
SplineMatrix<d> coarser(const SplineMatrix<d>& fine);

/// result = matrix x, on the rows; other places are left alone.
template <int d>
void apply(const SplineMatrix<d>& matrix, const Coefficients<d>& x, Coefficients<d>& result);

}  // namespace plumb
