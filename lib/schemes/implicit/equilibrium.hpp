#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/schemes/implicit/implicit_options.hpp"
#include "plumbline/schemes/implicit/newton.hpp"

namespace plumb {

/// One load step that ended in equilibrium.
struct LoadStep {
  double share;  ///< of the path, at its end
  NewtonResult newton;
};

/// Why the end of the path was not reached.
struct StaticFailure {
  std::string cause;              ///< "inverted", "non-finite", "stalled" or "limit-point"
  double share;                   ///< of the path that could not be reached from the one before
  UnsoundParticle particle;       ///< with J <= 0, if that is the cause
  std::vector<double> residuals;  ///< of the last search
  /// Says it in a sentence.
  std::string in_words() const;
};

/// The force of the supports of one boundary on the body [N] (per metre of thickness in 2D).
template <int d>
struct Reaction {
  std::string boundary;
  Vec<d> force;
};

/// What find_equilibrium() did.
template <int d>
struct StaticResult {
  std::vector<LoadStep> steps;           ///< those that converged
  int rejected = 0;                      ///< steps that were tried again with half their length
  std::vector<Reaction<d>> reactions;    ///< at the last equilibrium
  std::optional<StaticFailure> failure;  ///< nullopt: the end of the path was reached
  bool completed() const { return !failure; }
};

/// Called at every equilibrium on the way; the state has its displacements and its time.
template <int d>
using OnLoadStep = std::function<void(const State<d>& state, const LoadStep& step)>;

/// The way from no load to the loads and supports of the end time [s], as find_equilibrium() goes it, one
/// part after the other. The body, the actions and the state must outlive it.
template <int d>
class EquilibriumPath {
 public:
  EquilibriumPath(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                  const ImplicitOptions& options, State<d>& state);

  /// Goes on to this share of the load, in as many steps as it takes. The state is left at the last
  /// equilibrium.
  std::optional<StaticFailure> move_to(double share, const OnLoadStep<d>& on_step = {});

  /// Share that the next step would add.
  double length() const { return length_; }
  /// Starts the next step with this length, that of an earlier part of the path.
  void set_length(double length) { length_ = length; }
  double share() const { return share_; }
  int rejected() const { return rejected_; }
  const std::vector<LoadStep>& steps() const { return steps_; }
  /// Forces of the supports at the last equilibrium.
  std::vector<Reaction<d>> reactions();

 private:
  const Actions<d>& actions_;
  ImplicitOptions options_;
  State<d>& state_;
  double end_time_, share_, first_, length_;
  Eigen::VectorXd u_;
  Balance<d> balance_;
  DescentSolver solver_;
  bool tried_longer_ = false;  ///< in vain: then the next step does not grow
  int rejected_ = 0;
  std::vector<LoadStep> steps_;
};

/// Finds the equilibria of a body on the way to the loads and supports of the end time [s], from the state at
/// its time (0: no load) on. Loads and displacements that vary in time are taken at the time of the step;
/// constant ones grow in proportion to it. The state is left at the last equilibrium, at rest, so that a path
/// that could not be ended can be resumed. Dead loads and pressures that follow; any elastic law, any bond
/// table with the adjoint force, terms with an energy. Throws InputError if the body can move freely, or if
/// its force has no energy.
template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep<d>& on_step = {});

}  // namespace plumb
