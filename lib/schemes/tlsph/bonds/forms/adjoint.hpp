#pragma once
#include <string_view>

#include "lib/schemes/tlsph/bonds/pair_data.hpp"

namespace plumb {

/// Minus the derivative of the discrete strain energy with respect to x_i, by the same constants that make F:
/// f_i = sum_j (P_i c_ij - V_j/V_i P_j c_ji). Energy, linear and angular momentum are exact. THEORY (5.3).
struct Adjoint {
  static constexpr std::string_view name = "adjoint";

  template <int d>
  static Vec<d> other(const PairData<d>& pair) {
    return -pair.volume_j / pair.volume_i * pair.stencil_ji;
  }
  template <int d>
  static Vec<d> own(const PairData<d>& pair) {
    return pair.stencil_ij;
  }
};

}  // namespace plumb
