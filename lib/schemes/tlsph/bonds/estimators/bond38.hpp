#pragma once
#include <string_view>
#include <vector>

#include "lib/schemes/tlsph/bonds/estimators/bond.hpp"

namespace plumb {

/// (37) with (38) as printed: the pairwise gradients are of rank one, so that even the identity map is not
/// reproduced in 2D and 3D. Kept to show that it fails its patch test. THEORY (3.4).
struct Bond38 {
  static constexpr std::string_view name = "bond38";
  template <int d>
  static constexpr bool affine = d == 1;  ///< whether affine maps are reproduced

  template <int d>
  static std::vector<Vec<d>> stencil(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel) {
    std::vector<Vec<d>> c = Bond::stencil<d>(neighbours, kernel);
    double own = 0;  // V_i W~_ii
    for (std::size_t j = 0; j < c.size(); ++j)
      if (neighbours[j].separation.squaredNorm() == 0) own += kernel.weight[j];
    for (std::size_t j = 0; j < c.size(); ++j)
      if (neighbours[j].separation.squaredNorm() > 0) c[j] += own * kernel.gradient[j];
    return c;
  }
};

}  // namespace plumb
