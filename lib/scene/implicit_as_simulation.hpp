#pragma once
#include "plumbline/scene/simulation.hpp"

namespace plumb {

/// A body that goes from equilibrium to equilibrium (scheme "implicit"): a step of dt is the way to the loads
/// of dt later. Throws InputError if the body can move freely or the scene has no end time.
template <int d>
Simulation<d> implicit_as_simulation(const std::shared_ptr<TlsphSimulation<d>>& body, const Scene& scene);

}  // namespace plumb
