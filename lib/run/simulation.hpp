#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/actions/boundary_force.hpp"
#include "lib/measures/measures.hpp"
#include "lib/particles/snapshot.hpp"
#include "lib/run/run.hpp"
#include "lib/run/saved_state.hpp"
#include "lib/schemes/scheme.hpp"

namespace plumb {

/// What one particle shows, for probes. A total Lagrangian body makes it without a snapshot of all.
template <int d>
struct PointView {
  Vec<d> X, u, x;                     ///< reference position, displacement, position [m]
  Vec<d> v;                           ///< velocity [m/s]
  std::optional<Mat<3>> F = {};       ///< deformation gradient; nullopt: the scheme has none
  std::optional<Mat<3>> cauchy = {};  ///< Cauchy stress [Pa]; likewise
  double volume = 0;                  ///< current volume [m^d]
};

/// Numbers of a body that do not change in a run, and the work done so far.
struct Counts {
  Index particles = 0;
  Index pairs = 0;            ///< ordered pairs of neighbours
  Index most_neighbours = 0;  ///< of one particle
  Work work;
  double bytes_per_update = 0;  ///< THEORY (10.8); 0: not known
};

/// One array of a simulation, for `plumb explain` and memory figures.
struct ArrayEntry {
  std::string name;
  std::size_t bytes;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("name", self.name);
    visit("bytes", self.bytes);
  }
};

/// A body that moves by some scheme, as everything outside of the scheme sees it. Its functions are called
/// once a step or less often. What a scheme cannot say is an empty function.
template <int d>
struct Simulation {
  std::string scheme;
  StepControl control;
  std::vector<std::string> warnings;
  std::vector<std::string> energy_names;  ///< of the energies beside kinetic and strain energy
  double spacing = 0;                     ///< of the particles [m]
  int evaluations_per_step = 1;
  Steps steps;
  std::function<Snapshot<d>()> snapshot;
  std::function<PointView<d>(Index particle)> at;
  std::function<Energy()> energy;
  std::function<double()> energy_round_off;  ///< of the energy near the reference [J]; empty: none is known
  std::function<Momentum()> momentum;
  std::function<double()> hourglass_share;  ///< THEORY (8.4); empty: the scheme has none
  /// Work of "loads", "damping" and "supports" so far [J], of those that there are; empty: not accounted for.
  std::function<std::vector<NamedEnergy>()> external_work;
  std::function<std::vector<BoundaryForce<d>>()> reactions;  ///< empty: the scheme does not say
  std::function<double()>
      load_factor;              ///< that a path has found for the loads; empty: they are as they are given
  bool has_other_work = false;  ///< that external_work does not have
  std::function<std::vector<Statement>()> account;  ///< what it solves; empty: `plumb explain` knows itself
  std::function<Counts()> counts;
  std::function<std::vector<ArrayEntry>()> arrays;
  std::function<SavedState()> save;
  std::function<void(const SavedState&)> restore;  ///< InputError if it does not fit
  std::function<void()> begin;                     ///< once before the first step; empty: nothing to do
  std::function<void(bool sound)> close_step;      ///< after each step, also one that broke a bound; likewise
  /// Writes the conservation budget to this file from the beginning on; call it before begin(), which adds what reads behind
  /// the budget. Empty: the scheme has none.
  std::function<void(const std::filesystem::path&)> keep_budget;
};

/// Steps until the end, a failure, or until `observe` returns false. It is called at the start and after
/// every step.
template <int d>
RunResult run(Simulation<d>& simulation, const std::function<bool()>& observe, RunRecord& record);

}  // namespace plumb
