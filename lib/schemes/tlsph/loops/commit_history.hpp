#pragma once
#include "lib/schemes/tlsph/loops/body_history.hpp"

namespace plumb {

/// Moves the history of a body to its displacements, once a step; a body without history stays as it is.
template <int d>
void commit_history(const Solid<d>& solid, const State<d>& state) {
  const auto& history = solid.sweeps.history;
  if (!history) return;
  const Index blocks = solid.blocks();
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
  for (Index b = 0; b < blocks; ++b) history->commit(solid.bonds, state.u, solid.block(b));
}

}  // namespace plumb
