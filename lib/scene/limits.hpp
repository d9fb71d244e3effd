#pragma once
#include <string>
#include <vector>

#include "lib/scene/scene.hpp"

namespace plumb {

/// What is known of the scheme of a scene that it does not do, each as a sentence with what to choose
/// instead: irregular clouds without compatible bonds, and linear fields near the edges of a lattice. The run
/// may be worth making all the same, so these are told by `plumb explain` and not before every run.
std::vector<std::string> limits_of(const Scene& scene);

}  // namespace plumb
