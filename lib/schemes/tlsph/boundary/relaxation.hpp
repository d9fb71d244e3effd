#pragma once
#include <memory>
#include <optional>

#include "lib/schemes/tlsph/boundary/open_forces.hpp"

namespace plumb {

/// Brings a body to rest, THEORY (5.10): damps its motion critically for the frequency that the motion has.
/// It needs no number of the user.
template <int d>
class Relaxation {
 public:
  explicit Relaxation(std::shared_ptr<const OpenForces<d>> forces) : forces_(std::move(forces)) {}

  /// Damps the velocity after a step of length dt [s]. At every tenth step it looks at the forces: returns
  /// the norm of those on components that move freely, at velocity zero, relative to the larger one of the
  /// norms of the loads and of the forces of supports; nullopt at the other steps.
  std::optional<double> damp(const Solid<d>& solid, State<d>& state, double dt);

  /// The rate of the damping [1/s], all that it keeps from step to step.
  double rate() const { return rate_; }
  void set_rate(double rate) { rate_ = rate; }

 private:
  std::optional<double> look(const Solid<d>& solid, const State<d>& state);

  std::shared_ptr<const OpenForces<d>> forces_;
  double rate_ = 0;
};

}  // namespace plumb
