#pragma once
#include "lib/schemes/upwind.hpp"

namespace plumb {

/// Constant states: the jump is v_b - v_a. Dissipative pair by pair and of first order; a rigid spin is
/// braked.
template <int d, int W>
struct ConstantJump {
  static constexpr bool adjoint = false;

  ConstantJump(const UpwindSite<d>&, Index) {}
  Vec<d, Pack<W>> operator()(std::int64_t, Index, const Vec<d, Pack<W>>& dv, const Vec<d, Pack<W>>&) const {
    return dv;
  }
};

}  // namespace plumb
