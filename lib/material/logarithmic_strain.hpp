#pragma once
#include <cmath>

#include "lib/core/types.hpp"

namespace plumb {

/// Principal stretches of a symmetric b = F G F^T with their directions, and the strains ln(stretch). THEORY
/// (4.12).
struct LogarithmicStrain {
  Vec<3> square;      ///< eigenvalues of b
  Mat<3> directions;  ///< columns
  Vec<3> strain;      ///< ln of the stretches: half of the logarithms of `square`

  explicit LogarithmicStrain(const Mat<3>& b);

  Vec<3> deviator() const { return strain.array() - strain.mean(); }
  /// The tensor with these principal values.
  Mat<3> tensor(const Vec<3>& values) const {
    return directions * values.asDiagonal() * directions.transpose();
  }
  /// (strain_a - strain_b)/(square_a - square_b), without cancellation when the two are close.
  double slope(int a, int b) const {
    const double x = (square[a] - square[b]) / square[b];
    return 0.5 / square[b] * (std::abs(x) < 1e-300 ? 1.0 : std::log1p(x) / x);
  }
};

}  // namespace plumb
