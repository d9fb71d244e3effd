#include "lib/schemes/tlsph/measures/budget_file.hpp"

namespace plumb {
namespace {

/// In 2D linear momentum has x and y, angular momentum z only.
template <int d>
std::vector<std::string> columns(const BudgetSums& sums) {
  std::vector<std::string> names{"step", "time [s]"};
  for (const auto& part : sums.parts) {
    for (int k = 0; k < d; ++k)
      names.push_back(part.name + ": linear momentum " + "xyz"[k] + (d == 2 ? " [kg/s]" : " [kg m/s]"));
    for (int k = d == 2 ? 2 : 0; k < 3; ++k)
      names.push_back(part.name + ": angular momentum " + "xyz"[k] + (d == 2 ? " [kg m/s]" : " [kg m^2/s]"));
    names.push_back(part.name + ": energy" + (d == 2 ? " [J/m]" : " [J]"));
  }
  names.insert(names.end(), {"gap of linear momentum", "gap of angular momentum", "gap of energy"});
  return names;
}

}  // namespace

template <int d>
BudgetFile<d>::BudgetFile(const std::filesystem::path& file, Solid<d>& solid, const State<d>& state,
                          const std::vector<double>& weights)
    : budget_(solid, state, weights), series_(file, columns<d>(budget_.total())) {}

template <int d>
void BudgetFile<d>::observe(const Solid<d>& solid, const State<d>& state) {
  if (state.step > 0) budget_.close_step(solid, state);
  std::vector<double> row{static_cast<double>(state.step), state.time};
  for (const auto& part : budget_.total().parts) {
    row.insert(row.end(), part.linear.data(), part.linear.data() + d);
    row.insert(row.end(), part.angular.data() + (d == 2 ? 2 : 0), part.angular.data() + 3);
    row.push_back(part.energy);
  }
  const BudgetSums& step = budget_.step();
  row.insert(row.end(), {step.linear_gap, step.angular_gap, step.energy_gap});
  series_.append(row);
}

template class BudgetFile<2>;
template class BudgetFile<3>;

}  // namespace plumb
