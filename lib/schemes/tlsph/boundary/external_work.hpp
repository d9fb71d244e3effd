#pragma once
#include <memory>
#include <string>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"

namespace plumb {

/// Work of one kind of action on a body since its start.
struct WorkOf {
  std::string action;  ///< "loads", "damping" or "supports"
  double done = 0;     ///< [J] (per metre of thickness in 2D)
};

/// What a continued run needs of the work of one kind of action.
struct KeptWork {
  std::string action;
  double done = 0;              ///< [J]
  std::vector<double> carried;  ///< forces that count for the next step, too, weighed [N/m^d]
};

/// Work that loads, damping and supports that move do on a body: their forces, weighed as the integrator
/// weighs those of a step, times the mean of the velocities before and after it, THEORY (8.6). These are the
/// energies that the budget has for them. Kinds that a body does not have are not followed: nothing is added
/// to one whose supports stand still and that has no loads.
template <int d>
class ExternalWork {
 public:
  /// Reads the forces of the terms "loads", "damping" and "supports" of the body. Make it after the budget, if
  /// there is one.
  ExternalWork(Solid<d>& solid, const Actions<d>& actions, const ChosenIntegrator<d>& integrator,
               const State<d>& state);

  /// Closes the account of a step; call it after each.
  void close_step(const Solid<d>& solid, const State<d>& state);

  /// Lists the kinds that are followed, in the order of the terms.
  std::vector<WorkOf> done() const;

  std::vector<KeptWork> save() const;
  /// Goes on with what an earlier part of the run has saved. Returns false, and changes nothing of that kind, if it does not fit.
  bool restore(const std::vector<KeptWork>& saved);

 private:
  struct Account;
  std::vector<std::shared_ptr<Account>> accounts_;
  double time_ = 0;
};

}  // namespace plumb
