#pragma once
#include <string_view>
#include <vector>

#include "lib/schemes/tlsph/bonds/estimators/bond.hpp"

namespace plumb {

/// The paper's improved bond-based estimate, (36) in 1D and (37) with (39) in 2D and 3D, as a constant
/// stencil: c_ij = (S I - A_i) g_ij + w_ij e_ij / r_ij, w = V W~, g = V grad W~, S = sum_j w_ij (1 for
/// corrected kernels), A_i = sum_{j != i} w_ij e_ij (x) e_ij. THEORY (3.5).
struct Improved {
  static constexpr std::string_view name = "improved";

  template <int d>
  static std::vector<Vec<d>> stencil(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel) {
    std::vector<Vec<d>> c = Bond::stencil<d>(neighbours, kernel);
    Mat<d> share = Mat<d>::Zero();  // S I - A_i
    for (std::size_t j = 0; j < c.size(); ++j)
      share += kernel.weight[j] * Mat<d>::Identity() - c[j] * neighbours[j].separation.transpose();
    for (std::size_t j = 0; j < c.size(); ++j)
      if (neighbours[j].separation.squaredNorm() > 0) c[j] += share * kernel.gradient[j];
    return c;
  }
};

}  // namespace plumb
