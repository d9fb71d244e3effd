#pragma once
#include <string>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// What one cause did to the momenta and the energy of a body. Three components also in 2D; angular momentum
/// about the origin.
struct BudgetPart {
  std::string name;
  Vec<3> linear = Vec<3>::Zero();   ///< [kg m/s]
  Vec<3> angular = Vec<3>::Zero();  ///< [kg m^2/s]
  double energy = 0;                ///< [J]
};

/// Splits the changes of a step, or of all steps so far, by cause: "internal force", every other one by its name
/// (supports: reaction and boundary work), and "integrator", what is left to the way the step is made.
/// THEORY (8.5), (8.6), (8.10).
struct BudgetSums {
  std::vector<BudgetPart> parts;
  /// Change of the state that the parts do not explain, relative to sum m |v|, sum m |x| |v| and the kinetic
  /// energy: round-off, or the budget is wrong.
  double linear_gap = 0, angular_gap = 0, energy_gap = 0;
  /// The part of that name; InputError if there is none.
  const BudgetPart& part(const std::string& name) const;
  BudgetPart& part(const std::string& name);
};

/// Adds an impulse [kg m/s] at x [m] to the momenta of a part.
void push(const Vec<3>& impulse, const Vec<3>& x, BudgetPart& part);

/// Sums over particles what a step changed, and what that is compared with: sum m |v|, sum m |x| |v|, kinetic energy.
struct StateChange {
  BudgetPart change, scale;
  /// Adds a particle of mass m [kg] that went from x0 to x1 [m] with v [m/s], its velocity from v0 to v1.
  void add(double m, const Vec<3>& x0, const Vec<3>& x1, const Vec<3>& v0, const Vec<3>& v1, const Vec<3>& v);
};

/// Adds what the parts of a step did to those of the same places in `total`, and keeps the largest gaps.
void add_step(const BudgetSums& step, BudgetSums& total);

/// The parts of a step together.
BudgetPart sum_of(const std::vector<BudgetPart>& parts);

/// Writes the gaps of a step: what `explained` lacks of the change, relative to its scale.
void set_gaps(const BudgetPart& explained, const StateChange& of, BudgetSums& step);

/// Names the columns of a budget file: step and time, the sums of every part, the gaps of the step. In 2D linear momentum
/// has x and y, angular momentum z only; in 1D there is x and no angular momentum.
template <int d>
std::vector<std::string> budget_columns(const std::vector<BudgetPart>& parts);

/// Fills those columns. `total`: of all steps so far; the gaps are those of `step`.
template <int d>
std::vector<double> budget_row(long step_number, double time, const BudgetSums& total,
                               const BudgetSums& step);

}  // namespace plumb
