#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/actions/boundary_force.hpp"
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/implicit/implicit_options.hpp"
#include "lib/schemes/implicit/newton.hpp"

namespace plumb {

/// One load step that ended in equilibrium.
struct LoadStep {
  double share;  ///< of the path, at its end
  NewtonResult newton;
};

/// Why a point of the path was not reached.
struct StaticFailure {
  std::string cause;                ///< "inverted", "non-finite", "unsolved", "stalled" or "limit-point"
  double share;                     ///< of the path that could not be reached from the one before
  std::optional<Trouble> trouble;   ///< with J <= 0, if that is the cause
  std::optional<Index> most_moved;  ///< the particle that moves most where conjugate gradients do not end
  std::vector<double> residuals;    ///< of the last search, relative to the forces
  /// Says it in a sentence.
  std::string in_words() const;
};

/// Called at every equilibrium on the way, with its displacements and its time.
using OnLoadStep = std::function<void(const BodyMotion& equilibrium, const LoadStep& step)>;

/// Takes a body from equilibrium to equilibrium, from no load at time 0 to the loads and supports of the end
/// time [s]. Loads and displacements that vary in time are taken at the time of the step; constant ones grow
/// in proportion to it. Dead loads and pressures that follow; any law, any bond table with the
/// adjoint force, terms with an energy. A law with history is moved on at every equilibrium.
template <int d>
class LoadPath {
 public:
  /// The actions must outlive the path. It begins at the time of `from`. Throws InputError if the body can
  /// move freely.
  LoadPath(StoredEnergy<d> energy, const Actions<d>& actions, double end_time, const ImplicitOptions& options,
           const BodyMotion& from);

  /// Goes from the motion's time to `time` [s], in as many load steps as it needs. The motion is left at the
  /// last equilibrium, at rest; if it is not the one that was asked for, what is returned says why.
  std::optional<StaticFailure> go_to(double time, BodyMotion& motion, const OnLoadStep& on_step = {});

  double next_step() const { return length_ * end_time_; }     ///< the load step that is tried next [s]
  void set_next_step(double dt) { length_ = dt / end_time_; }  ///< goes on as an earlier path would have
  int rejected() const { return rejected_; }  ///< steps that were tried again with half their length
  /// Returns what the supports do to the body in an equilibrium, boundary by boundary.
  std::vector<BoundaryForce<d>> reactions(const BodyMotion& equilibrium);

 private:
  PathPoint at(double share) const { return {share * end_time_, share}; }

  const Actions<d>& actions_;
  double end_time_;
  ImplicitOptions options_;
  Balance<d> balance_;
  TangentSolver<d> solver_;
  double first_, length_;  ///< of load steps, as shares of the path
  int rejected_ = 0;
};

}  // namespace plumb
