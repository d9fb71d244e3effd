#include "lib/run/simulation.hpp"

namespace plumb {

template <int d>
RunResult run(Simulation<d>& simulation, const std::function<bool()>& observe, RunRecord& record) {
  if (simulation.control.energy_bound && !record.initial_energy)
    record.initial_energy = simulation.energy().total();
  if (simulation.begin) simulation.begin();
  bool at_the_start = true;
  const auto look = [&] {
    if (!at_the_start && simulation.close_step) simulation.close_step(true);
    at_the_start = false;
    return !observe || observe();
  };
  const RunResult result = step_to_the_end(simulation.steps, simulation.control, look, record);
  if (result.failure && simulation.close_step) simulation.close_step(false);
  return result;
}

template RunResult run<1>(Simulation<1>&, const std::function<bool()>&, RunRecord&);
template RunResult run<2>(Simulation<2>&, const std::function<bool()>&, RunRecord&);
template RunResult run<3>(Simulation<3>&, const std::function<bool()>&, RunRecord&);

}  // namespace plumb
