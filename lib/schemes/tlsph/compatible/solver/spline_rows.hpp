#pragma once
#include "lib/schemes/tlsph/compatible/solver/spline_matrix.hpp"

// What the matrices of all grids are made with.
namespace plumb {

inline constexpr int row_width = 2 * spline_reach + 1;  ///< entries of a row along an axis

/// Numbers of rows by place; -1 where there is none.
template <int d>
std::vector<std::int32_t> rows_by_place(const SplineMatrix<d>& matrix);

/// Rows for the marked places, entries zero.
template <int d>
void make_rows(SplineMatrix<d>& matrix, const std::vector<char>& used);

/// With the entries in place: the inverse diagonal, and the largest eigenvalue by power iterations.
template <int d>
void finish(SplineMatrix<d>& matrix);

}  // namespace plumb
