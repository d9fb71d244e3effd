#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"

/// Reads the motion of single particles from a state.
namespace plumb {

/// Finds the deformation gradient of one particle, THEORY (10.1), (10.6).
template <int d>
Mat<d> deformation_gradient_of(const Solid<d>& solid, const State<d>& state, Index particle);

/// Finds the current position of one particle [m].
template <int d>
Vec<d> position_of(const Solid<d>& solid, const State<d>& state, Index particle) {
  return solid.cloud.X[particle] + vector_at<d>(state.u, solid.bonds.slots.of(particle));
}

}  // namespace plumb
