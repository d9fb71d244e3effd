#pragma once
#include "lib/schemes/tlsph/compatible/solver/spline_matrix.hpp"

namespace plumb {

/// Coefficients in single precision.
template <int d>
using RoughCoefficient = Eigen::Matrix<float, lanes<d>, 1>;
template <int d>
using RoughCoefficients = std::vector<RoughCoefficient<d>>;

/// A spline matrix in single precision, for smoothing. It must not be applied to smooth fields: what it
/// answers to them is less than the rounding of its entries.
template <int d>
struct SplineSmoother {
  SplineGrid<d> grid;
  std::vector<Index> places;            ///< of the rows
  std::vector<float> entries;           ///< per row: row_size
  std::vector<float> inverse_diagonal;  ///< per row
  double largest;                       ///< bound of the eigenvalues of (diagonal)^-1 matrix

  Index rows() const { return static_cast<Index>(places.size()); }
};

/// Makes the smoother of a matrix of splines.
template <int d>
SplineSmoother<d> spline_smoother(const SplineMatrix<d>& matrix);

/// result = matrix x, on the rows; other places are left alone.
template <int d>
void apply(const SplineSmoother<d>& matrix, const RoughCoefficients<d>& x, RoughCoefficients<d>& result);

}  // namespace plumb
