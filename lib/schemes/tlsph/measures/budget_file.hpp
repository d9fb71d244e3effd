#pragma once
#include <filesystem>

#include "lib/output/series.hpp"
#include "lib/schemes/tlsph/measures/budget.hpp"

namespace plumb {

/// Writes the conservation budget of a run, one line a step: time, for every part what it has done so far to
/// linear momentum, angular momentum and energy, and the gaps of the step.
template <int d>
class BudgetFile {
 public:
  /// Adds the budget to the body and starts the file. `weights`: ChosenIntegrator::weights.
  BudgetFile(const std::filesystem::path& file, Solid<d>& solid, const State<d>& state,
             const std::vector<double>& weights);
  /// For the run's observer.
  void observe(const Solid<d>& solid, const State<d>& state);

 private:
  Budget<d> budget_;
  CsvSeries series_;
};

}  // namespace plumb
