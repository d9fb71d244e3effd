#pragma once
#include <string_view>
#include <vector>

#include "lib/kernel/correction.hpp"

namespace plumb {

/// The usual SPH estimate (33), (24) in difference form: c_ij = V_j grad W~_ij. THEORY (3.2).
struct Standard {
  static constexpr std::string_view name = "standard";

  template <int d>
  static std::vector<Vec<d>> stencil(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel) {
    std::vector<Vec<d>> c = kernel.gradient;
    for (std::size_t j = 0; j < c.size(); ++j)
      if (neighbours[j].separation.squaredNorm() == 0) c[j].setZero();
    return c;
  }
};

}  // namespace plumb
