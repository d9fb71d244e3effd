#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "plumb/run/probe.hpp"
#include "plumbline/diagnostics/measures.hpp"
#include "plumbline/scene/simulation.hpp"

namespace plumb {

/// Seconds that a run took. CPU time counts all threads.
struct Timing {
  double setup = 0;  ///< wall time of reading and building [s]
  double wall = 0;   ///< wall time of the steps [s]
  double cpu = 0;    ///< CPU time of the steps [s]
};

/// Everything that the summary of a run is made of.
template <int d>
struct FinishedRun {
  const Scene& scene;
  const Simulation<d>& simulation;  ///< with the last good state
  const RunResult& result;
  const std::vector<BoundProbe>& probes;
  Energy initial_energy;
  Momentum initial_momentum;
  Timing timing;
};

/// The summary as in interface.md, plus "hourglass_share" (THEORY (8.4)). The drifts are distances from the
/// initial momenta relative to the initial scales sum m |v| and sum m |x| |v|; for a body that starts at rest
/// relative to the scales of the last state. In 2D energies and momenta are per metre of thickness.
template <int d>
nlohmann::ordered_json summary(const FinishedRun<d>& run);

/// The energy, drift and extent of the summary as some lines for people.
template <int d>
std::string summary_text(const FinishedRun<d>& run);

}  // namespace plumb
