#pragma once
#include <string_view>

#include "lib/schemes/tlsph/bonds/pair_data.hpp"

namespace plumb {

/// The paper's form (22), with the standard gradient whatever estimator makes F:
/// f_i = 1/2 sum_j V_j (P_i + P_j) (grad W~_j(X_i) - grad W~_i(X_j)). Linear momentum is exact. THEORY (5.2).
struct Symmetrised {
  static constexpr std::string_view name = "symmetrised";

  template <int d>
  static Vec<d> other(const PairData<d>& pair) {
    return 0.5 * (pair.gradient_ij - pair.volume_j / pair.volume_i * pair.gradient_ji);
  }
  template <int d>
  static Vec<d> own(const PairData<d>& pair) {
    return other<d>(pair);
  }
};

}  // namespace plumb
