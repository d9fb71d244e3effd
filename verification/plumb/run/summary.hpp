#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "lib/run/checkpoints.hpp"
#include "lib/run/probe.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb::app {

/// Everything that the summary of a run is made of.
template <int d>
struct FinishedRun {
  const Scene& scene;
  const Simulation<d>& simulation;  ///< with the last good state
  const TlsphBody<d>* tlsph;        ///< the same of scheme "tlsph"; null for any other
  const RunResult& result;
  const std::vector<BoundProbe>& probes;
  const RunRecord& record;
};

/// The summary for programs. "hourglass_share": THEORY (8.4). The drifts are distances from the initial
/// momenta relative to the initial scales sum m |v| and sum m |x| |v|; for a body that starts at rest
/// relative to the scales of the last state. "error", if the scene has an exact displacement: root of the mean square of what the
/// particles are off by, over that of the exact ones, and in metres. In 2D energies and momenta are per metre of thickness.
template <int d>
nlohmann::ordered_json summary(const FinishedRun<d>& run);

/// The same for people: times, the budget of the energy, the drift of the momenta of a body that nothing
/// holds, extents and probes.
template <int d>
std::string summary_text(const FinishedRun<d>& run);

}  // namespace plumb::app
