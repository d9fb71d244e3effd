#include "lib/schemes/tlsph/measures/budget_file.hpp"

#include <fmt/format.h>

#include "lib/measures/body_units.hpp"

namespace plumb {
namespace {

/// In 2D linear momentum has x and y, angular momentum z only; in 1D there is x and no angular momentum.
template <int d>
std::vector<std::string> columns(const BudgetSums& sums) {
  using Units = BodyUnits<d>;
  std::vector<std::string> names{"step", "time [s]"};
  for (const auto& part : sums.parts) {
    for (int k = 0; k < d; ++k)
      names.push_back(
          fmt::format("{}: linear momentum {} [{}]", part.name, "xyz"[k], Units::linear_momentum));
    for (int k = Units::first_angular; k < 3; ++k)
      names.push_back(
          fmt::format("{}: angular momentum {} [{}]", part.name, "xyz"[k], Units::angular_momentum));
    names.push_back(fmt::format("{}: energy [{}]", part.name, Units::energy));
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
    row.insert(row.end(), part.angular.data() + BodyUnits<d>::first_angular, part.angular.data() + 3);
    row.push_back(part.energy);
  }
  const BudgetSums& step = budget_.step();
  row.insert(row.end(), {step.linear_gap, step.angular_gap, step.energy_gap});
  series_.append(row);
}

template class BudgetFile<1>;
template class BudgetFile<2>;
template class BudgetFile<3>;

}  // namespace plumb
