#pragma once
#include <memory>

#include "lib/run/simulation.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {

/// A scene made ready to run by the scheme that it names.
template <int d>
struct BuiltScene {
  Simulation<d> simulation;
  std::shared_ptr<TlsphBody<d>> tlsph;  ///< the body of scheme "tlsph"; null for any other scheme
};

/// Builds the scene: "tlsph" by make_tlsph() and as_simulation() below, any other scheme by make_scheme_simulation()
/// (scheme_simulation.hpp). Throws InputError.
template <int d>
BuiltScene<d> make_simulation(const Scene& scene);

/// Makes a Simulation of a total Lagrangian body, which it keeps alive together with what follows it through a run (closest
/// pairs, reactions, relaxation, work of supports, budget). Control and warnings are copied: from then on those of the
/// Simulation count. save() keeps u, v, what the integrator carries, the work of supports and the rate of relaxation.
template <int d>
Simulation<d> as_simulation(const std::shared_ptr<TlsphBody<d>>& body, const MaterialChoice& material);

/// What a total Lagrangian body shows of its state.
template <int d>
Snapshot<d> snapshot_of(const Solid<d>& solid, const State<d>& state, const MaterialChoice& material);

}  // namespace plumb
