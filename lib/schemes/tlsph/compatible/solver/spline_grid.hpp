#pragma once
#include <array>

#include "lib/schemes/tlsph/compatible/solver/bond_operator.hpp"

namespace plumb {

/// Number of places that splines reach beyond their own along an axis: those of a row of the normal matrix.
inline constexpr int spline_reach = 4;

/// Computes base^exponent, for an exponent of at least 0.
constexpr int int_power(int base, int exponent) {
  return exponent == 0 ? 1 : base * int_power(base, exponent - 1);
}

/// Cubic B-splines on a regular grid, cells[k] + 3 of them along axis k, in an array with `spline_reach`
/// empty places on each side, so that no loop asks where the grid ends.
template <int d>
struct SplineGrid {
  Vec<d> origin, spacing;
  std::array<Index, d> cells;
  std::array<Index, d> stride;  ///< from one place to the next along each axis
  Index places;

  Index splines(int axis) const { return cells[axis] + 3; }
  Index place(const std::array<Index, d>& spline) const {
    Index at = 0;
    for (int k = 0; k < d; ++k) at += (spline[k] + spline_reach) * stride[k];
    return at;
  }
  std::array<Index, d> spline(Index at) const {
    std::array<Index, d> k;
    for (int a = d; a-- > 0; at %= stride[a]) k[a] = at / stride[a] - spline_reach;
    return k;
  }
};

/// Makes the grid of so many cells from `origin` on.
template <int d>
SplineGrid<d> spline_grid(const Vec<d>& origin, const Vec<d>& spacing, const std::array<Index, d>& cells);

/// The grid over a box, with the least spacing that is not below `least`.
template <int d>
SplineGrid<d> grid_over(const std::vector<Vec<d>>& X, double least);

/// The grid of twice the spacing.
template <int d>
SplineGrid<d> coarser(const SplineGrid<d>& grid);

/// The 4 splines per axis that are not zero at a point: values and slopes.
template <int d>
struct SplineValues {
  std::array<Index, d> cell;  ///< number of the first along each axis
  std::array<std::array<double, 4>, d> value, slope;
};
template <int d>
SplineValues<d> splines_at(const SplineGrid<d>& grid, const Vec<d>& X);

/// Lines along the first axis through the splines around a point.
template <int d>
inline constexpr int lines = int_power(4, d - 1);
/// Per line, the product of the values along the other axes: entry 0 without a slope, entry k with the slope
/// along axis k.
template <int d>
std::array<std::array<double, d>, lines<d>> across(const SplineValues<d>& s);

/// Coefficients of one spline for all components, and of all splines (by place).
template <int d>
using Coefficient = Eigen::Matrix<double, lanes<d>, 1>;
template <int d>
using Coefficients = std::vector<Coefficient<d>>;

/// Between grids: a spline K of twice the spacing is the sum of splines 2K - 3 .. 2K + 1 with these weights,
/// along each axis.
inline constexpr std::array<double, 5> two_scale = {0.125, 0.5, 0.75, 0.5, 0.125};
template <int d>
void add_refined(const SplineGrid<d>& coarse, const Coefficients<d>& c, const SplineGrid<d>& fine,
                 Coefficients<d>& x);
template <int d>
void coarsen(const SplineGrid<d>& fine, const Coefficients<d>& r, const SplineGrid<d>& coarse,
             Coefficients<d>& c);

}  // namespace plumb
