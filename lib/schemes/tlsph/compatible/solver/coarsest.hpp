#pragma once
#include "lib/schemes/tlsph/compatible/solver/spline_matrix.hpp"

namespace plumb {

/// What solves the coarsest level: a dense inverse. With fixed volumes one of `rows` rows serves all
/// components; with unknown ones w_V |div l|^2 joins them, in d x rows (component fastest).
struct Coarsest {
  Eigen::MatrixXd inverse;
  bool coupled;
};

/// The matrix must be that of the bonds; X: positions [spacings].
template <int d>
Coarsest coarsest(const SplineMatrix<d>& matrix, const std::vector<Vec<d>>& X, double volume_weight);

/// x = inverse r at the places of the matrix's rows.
template <int d>
void solve(const Coarsest& coarsest, const std::vector<Index>& places, const Coefficients<d>& r,
           Coefficients<d>& x);

}  // namespace plumb
