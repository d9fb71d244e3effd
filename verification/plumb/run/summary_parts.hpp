#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/measures/measures.hpp"
#include "verification/plumb/run/summary.hpp"

/// What the summary for programs and the one for people share.
namespace plumb::app {

/// Where the energy of the last state is, and where it came from [J] (per metre of thickness in 2D):
/// total = kinetic + strain + all terms.
struct EnergyBudget {
  double kinetic = 0, strain = 0, total = 0, initial = 0;
  std::map<std::string, double> terms;  ///< of the optional terms that have one, by name ("hourglass")
  /// Work of loads, of damping, of supports that move and of walls, since the start; empty: the scheme does not account
  /// for it.
  std::optional<double> load_work, damping_work, support_work, contact_work;
  std::vector<std::string> at_work;  ///< which of them there are: "loads", "damping", "supports", "contact"
  std::optional<double>
      dissipated;  ///< turned into heat by the scheme since the start; empty: it does not say
  /// (total - initial - works) / (initial + sum of |works|): none for a body at rest, whose energy is round-off, and none
  /// where something else does work.
  std::optional<double> net_change;

  /// That of an action of at_work.
  std::optional<double>& work_of(std::string_view action) {
    return action == "loads"     ? load_work
           : action == "damping" ? damping_work
           : action == "contact" ? contact_work
                                 : support_work;
  }
  double work() const {
    return load_work.value_or(0) + damping_work.value_or(0) + support_work.value_or(0) +
           contact_work.value_or(0);
  }
};
template <int d>
EnergyBudget energy_budget(const FinishedRun<d>& run);

/// Distances from the initial momenta relative to the first scale that is not zero, the initial one or that
/// of the last state; 0 where there is no motion at all.
struct Drifts {
  double linear, angular;
};
template <int d>
Drifts drifts_of(const FinishedRun<d>& run);

/// "completed", "unstable" or "interrupted".
const char* status_of(const RunResult& result);

/// Whether nothing acts on the body from outside, so that its momenta are conserved.
inline bool is_free(const Scene& scene) {
  return scene.boundaries.empty() && scene.contacts.empty() && !scene.load && !scene.method.damping;
}

}  // namespace plumb::app
