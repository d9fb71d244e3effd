#pragma once
#include <memory>
#include <string>
#include <vector>

#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// What one cause did to the momenta and the energy of a body. Three components also in 2D; angular momentum
/// about the origin.
struct BudgetPart {
  std::string name;
  Vec<3> linear = Vec<3>::Zero();   ///< [kg m/s]
  Vec<3> angular = Vec<3>::Zero();  ///< [kg m^2/s]
  double energy = 0;                ///< [J]
};

/// The changes of a step, or of all steps so far, split by cause: "internal force", every term by its name
/// (supports: reaction and boundary work), and "integrator", what is left to the way the step is made.
/// THEORY (8.5)-(8.7).
struct BudgetSums {
  std::vector<BudgetPart> parts;
  /// Change of the state that the parts do not explain, relative to sum m |v|, sum m |x| |v| and the kinetic
  /// energy: round-off, or the budget is wrong.
  double linear_gap = 0, angular_gap = 0, energy_gap = 0;
  /// The part of that name; InputError if there is none.
  const BudgetPart& part(const std::string& name) const;
};

/// The conservation budget of a body: follows the force through its terms. Made when the last term has been
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
