#include "lib/measures/budget_sums.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>  // cross
#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/measures/body_units.hpp"

namespace plumb {
namespace {

void add(const BudgetPart& part, BudgetPart& to) {
  to.linear += part.linear;
  to.angular += part.angular;
  to.energy += part.energy;
}

double relative(double gap, double scale) {
  return scale > 0 ? gap / scale : gap;
}

/// The part of that name; InputError if there is none.
template <class Parts>
auto& named(Parts& parts, const std::string& name) {
  for (auto& part : parts)
    if (part.name == name) return part;
  throw InputError("the budget has no part \"" + name + "\"", "parts are the causes that the body has", "");
}

}  // namespace

const BudgetPart& BudgetSums::part(const std::string& name) const {
  return named(parts, name);
}

BudgetPart& BudgetSums::part(const std::string& name) {
  return named(parts, name);
}

void push(const Vec<3>& impulse, const Vec<3>& x, BudgetPart& part) {
  part.linear += impulse;
  part.angular += x.cross(impulse);
}

void StateChange::add(double m, const Vec<3>& x0, const Vec<3>& x1, const Vec<3>& v0, const Vec<3>& v1,
                      const Vec<3>& v) {
  change.linear += m * (v1 - v0);
  change.angular += m * (x1.cross(v1) - x0.cross(v0));
  change.energy += 0.5 * m * (v1.squaredNorm() - v0.squaredNorm());
  scale.linear[0] += m * v.norm();
  scale.angular[0] += m * (0.5 * (x0 + x1)).norm() * v.norm();
  scale.energy += 0.5 * m * v.squaredNorm();
}

void add_step(const BudgetSums& step, BudgetSums& total) {
  for (std::size_t k = 0; k < step.parts.size(); ++k) add(step.parts[k], total.parts[k]);
  total.linear_gap = std::max(total.linear_gap, step.linear_gap);
  total.angular_gap = std::max(total.angular_gap, step.angular_gap);
  total.energy_gap = std::max(total.energy_gap, step.energy_gap);
}

BudgetPart sum_of(const std::vector<BudgetPart>& parts) {
  BudgetPart sum;
  for (const auto& part : parts) add(part, sum);
  return sum;
}

void set_gaps(const BudgetPart& explained, const StateChange& of, BudgetSums& step) {
  step.linear_gap = relative((explained.linear - of.change.linear).norm(), of.scale.linear[0]);
  step.angular_gap = relative((explained.angular - of.change.angular).norm(), of.scale.angular[0]);
  step.energy_gap = relative(std::abs(explained.energy - of.change.energy), of.scale.energy);
}

template <int d>
std::vector<std::string> budget_columns(const std::vector<BudgetPart>& parts) {
  using Units = BodyUnits<d>;
  std::vector<std::string> names{"step", "time [s]"};
  for (const auto& part : parts) {
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

template <int d>
std::vector<double> budget_row(long step_number, double time, const BudgetSums& total,
                               const BudgetSums& step) {
  std::vector<double> row{static_cast<double>(step_number), time};
  for (const auto& part : total.parts) {
    row.insert(row.end(), part.linear.data(), part.linear.data() + d);
    row.insert(row.end(), part.angular.data() + BodyUnits<d>::first_angular, part.angular.data() + 3);
    row.push_back(part.energy);
  }
  row.insert(row.end(), {step.linear_gap, step.angular_gap, step.energy_gap});
  return row;
}

#define PLUMBLINE_INSTANTIATE(d)                                                       \
  template std::vector<std::string> budget_columns<d>(const std::vector<BudgetPart>&); \
  template std::vector<double> budget_row<d>(long, double, const BudgetSums&, const BudgetSums&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
