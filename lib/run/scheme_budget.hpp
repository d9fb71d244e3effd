#pragma once
#include <filesystem>
#include <vector>

#include "lib/measures/budget_sums.hpp"
#include "lib/output/series.hpp"
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Where a body stands between two steps, for its budget.
template <int d>
struct Standing {
  double time;  ///< [s]
  long step;
  std::vector<Vec<d>> x, v;  ///< by particle [m], [m/s]
  OutsideWork works;
  double stored;  ///< all energies but the kinetic one, and what has become heat [J]
};

/// The conservation budget of a scheme whose velocities OutsideForces follows: one line of a file a step, as for "tlsph".
/// The parts are "internal force", those of loads, supports, damping and contact that the body has, and "integrator".
/// Velocities that no cause explains show in the gaps. THEORY (8.10).
template <int d>
class SchemeBudget {
 public:
  /// Starts the file. `places`: of the particles in the fields of OutsideForces, which must follow the changes of the
  /// velocities by then: OutsideForces::follow_changes().
  SchemeBudget(const std::filesystem::path& file, const OutsideForces<d>& outside, std::vector<Index> places,
               Standing<d> start);

  /// Closes the account of a step; call it after each.
  void close_step(const OutsideForces<d>& outside, Standing<d> now);

  const BudgetSums& step() const { return step_; }    ///< of the last step
  const BudgetSums& total() const { return total_; }  ///< of all steps; gaps: the largest of all steps

 private:
  void add_impulses(const OutsideForces<d>& outside, const Standing<d>& now, StateChange& state);
  void add_supports(const OutsideForces<d>& outside, const Standing<d>& now);

  std::vector<Index> places_;
  Standing<d> before_;
  BudgetSums step_, total_;
  CsvSeries series_;
};

}  // namespace plumb
