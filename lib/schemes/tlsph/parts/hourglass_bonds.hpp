#pragma once
#include "lib/kernel/kernel.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Spring constants on the bonds of a body's table, shared by the same rows.
struct HourglassBonds {
  AlignedVector own;         ///< per bond, width: k_ij [N/m]
  AlignedVector other;       ///< per bond, width: k_ji [N/m]
  AlignedVector per_volume;  ///< per slot: 1/V_i [1/m^d]; 0 for empty slots

  std::size_t bytes() const { return (own.size() + other.size() + per_volume.size()) * sizeof(double); }
};

/// k_ij = alpha mu V_i w_ij / r_ij^2 with Shepard weights w_ij = V_j W_ij / sum V W. THEORY (12.1).
template <int d>
HourglassBonds hourglass_bonds(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha);

/// Second derivatives of the hourglass energy; the same at every state, for it is quadratic.
template <int d>
void add_hourglass_stiffness(const Solid<d>& solid, const HourglassBonds& k, const AddStiffness& add);

}  // namespace plumb
