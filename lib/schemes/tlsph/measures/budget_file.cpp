#include "lib/schemes/tlsph/measures/budget_file.hpp"

namespace plumb {
template <int d>
BudgetFile<d>::BudgetFile(const std::filesystem::path& file, Solid<d>& solid, const State<d>& state,
                          const std::vector<double>& weights)
    : budget_(solid, state, weights), series_(file, budget_columns<d>(budget_.total().parts)) {}

template <int d>
void BudgetFile<d>::observe(const Solid<d>& solid, const State<d>& state) {
  if (state.step > 0) budget_.close_step(solid, state);
  series_.append(budget_row<d>(state.step, state.time, budget_.total(), budget_.step()));
}

template class BudgetFile<1>;
template class BudgetFile<2>;
template class BudgetFile<3>;

}  // namespace plumb
