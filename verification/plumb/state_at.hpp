#pragma once
#include <fmt/format.h>

#include <string>

#include "lib/core/error.hpp"
#include "lib/run/checkpoint.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb::app {

/// The state of a checkpoint, or of the end of the scene's run if `at` is "end". InputError if there is none.
template <int d>
SavedState saved_state(const Scene& scene, const std::string& at) {
  if (at != "end") {
    const Checkpoint checkpoint = read_checkpoint(at);
    if (checkpoint.dimension != d)
      throw InputError(fmt::format("a checkpoint in {}D", checkpoint.dimension),
                       fmt::format("the scene is in {}D", d),
                       "name the checkpoint that this scene's run has written");
    return checkpoint.state;
  }
  Simulation<d> simulation = make_simulation<d>(scene).simulation;
  RunRecord history;
  if (!run<d>(simulation, {}, history).completed())
    throw InputError("the scene's run does not reach its end", "it fails on the way",
                     "see plumb run, and name the checkpoint that it leaves");
  return simulation.save();
}

}  // namespace plumb::app
