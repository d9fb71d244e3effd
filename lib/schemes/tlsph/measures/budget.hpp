#pragma once
#include <memory>
#include <string>
#include <vector>

#include "lib/measures/budget_sums.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// The conservation budget of a body, THEORY (8.5), (8.6), (8.7): follows the force through its terms. Made when the last term has been
/// added; nothing of it is in a solid for which none is made. Costs two fields of d components for the
/// internal force and every term, and another pass over the bonds at each evaluation.
template <int d>
class Budget {
 public:
  /// Puts probes between the terms of `solid`. `weights`: ChosenIntegrator::weights. InputError if there are none.
  Budget(Solid<d>& solid, const State<d>& state, const std::vector<double>& weights);

  /// Closes the account of a step; call it after each.
  void close_step(const Solid<d>& solid, const State<d>& state);

  const BudgetSums& step() const { return step_; }    ///< of the last step
  const BudgetSums& total() const { return total_; }  ///< of all steps; gaps: the largest of all steps

 private:
  struct Account;
  std::shared_ptr<Account> account_;
  BudgetSums step_, total_;
};

}  // namespace plumb
