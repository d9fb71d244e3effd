#pragma once
#include "lib/core/types.hpp"

namespace plumb {

/// What a momentum form may use of the pair i, j.
template <int d>
struct PairData {
  double volume_i, volume_j;        ///< [m^d]
  Vec<d> stencil_ij, stencil_ji;    ///< c_ij, c_ji that make F_i, F_j [1/m]
  Vec<d> gradient_ij, gradient_ji;  ///< V_j grad W~_j(X_i), V_i grad W~_i(X_j) [1/m]
};

}  // namespace plumb
