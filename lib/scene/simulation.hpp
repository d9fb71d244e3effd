#pragma once
#include <memory>

#include "lib/run/simulation.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {

/// A scene made ready to run by the scheme that it names.
template <int d>
struct BuiltScene {
  Simulation<d> simulation;
  std::shared_ptr<TlsphSimulation<d>> tlsph;  ///< the body of scheme "tlsph"; null for any other scheme
};

/// Builds the scene. Throws InputError.
template <int d>
BuiltScene<d> make_simulation(const Scene& scene);

/// A total Lagrangian body as the harness sees it.
template <int d>
Simulation<d> as_simulation(const std::shared_ptr<TlsphSimulation<d>>& body, const MaterialChoice& material);

/// What a total Lagrangian body shows of its state.
template <int d>
Snapshot<d> snapshot_of(const Solid<d>& solid, const State<d>& state, const MaterialChoice& material);

}  // namespace plumb
