#pragma once
#include <memory>

#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"

namespace plumb {

/// Work that supports do on a body by moving it [J] (per metre of thickness in 2D): the power of their
/// reactions, weighed as the integrator weighs the forces of a step. Nothing is added to a body whose
/// supports stand still. THEORY (8.6).
template <int d>
class SupportWork {
 public:
  /// Reads the force that these supports of the body take off, with the weights of the stepper. Make it after
  /// the budget, if there is one.
  SupportWork(Solid<d>& solid, const std::vector<Support<d>>& supports, const Stepper<d>& stepper);

  /// Goes on with the work of an earlier run.
  void resume(double done, double power);
  /// Closes the account of a step: for the run's observer, which sees the start and the end of every step.
  void observe(const State<d>& state);

  double done() const { return done_; }    ///< so far [J]
  double power() const { return power_; }  ///< that the last evaluation adds to the next step, weighed [W]

 private:
  struct Account;
  std::shared_ptr<Account> account_;  ///< null if no support moves
  double done_ = 0, power_ = 0, time_ = 0;
};

}  // namespace plumb
