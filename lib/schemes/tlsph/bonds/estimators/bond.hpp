#pragma once
#include <string_view>
#include <vector>

#include "lib/kernel/correction.hpp"

namespace plumb {

/// The plain bond-based estimate (34)-(35): the average of the pairwise gradients without the particle's own
/// bond, c_ij = V_j W~_ij e_ij / r_ij. Not consistent: on x = X it gives sum_j V_j W~_ij - V_i W~_ii in 1D.
/// THEORY (3.3).
struct Bond {
  static constexpr std::string_view name = "bond";
  template <int d>
  static constexpr bool affine = false;  ///< whether affine maps are reproduced

  template <int d>
  static std::vector<Vec<d>> stencil(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel) {
    std::vector<Vec<d>> c(neighbours.size(), Vec<d>::Zero());
    for (std::size_t j = 0; j < c.size(); ++j) {
      const Vec<d>& X = neighbours[j].separation;
      const double r2 = X.squaredNorm();
      if (r2 > 0) c[j] = kernel.weight[j] / r2 * X;
    }
    return c;
  }
};

}  // namespace plumb
