#include "lib/run/scheme_budget.hpp"

#include <Eigen/Geometry>  // cross
#include <utility>

#include "lib/core/in_space.hpp"

namespace plumb {
namespace {

/// The causes that a body has.
template <int d>
std::vector<BudgetPart> parts_of(const OutsideForces<d>& outside) {
  std::vector<BudgetPart> parts{{"internal force"}};
  if (outside.loads_body()) parts.push_back({"loads"});
  if (outside.damps()) parts.push_back({"damping"});
  if (!outside.held().empty()) parts.push_back({"supports"});
  if (!outside.contact().empty()) parts.push_back({"contact"});
  parts.push_back({"integrator"});
  return parts;
}

/// The vector of a slot with three components; zero of a field that is empty.
template <int d>
Vec<3> at(const Field& field, Index slot) {
  return field.components() > 0 ? in_space<d>(vector_at<d>(field, slot)) : Vec<3>(Vec<3>::Zero());
}

}  // namespace

template <int d>
SchemeBudget<d>::SchemeBudget(const std::filesystem::path& file, const OutsideForces<d>& outside,
                              std::vector<Index> places, Standing<d> start)
    : places_(std::move(places)),
      before_(std::move(start)),
      step_{parts_of(outside)},
      total_(step_),
      series_(file, budget_columns<d>(step_.parts)) {
  series_.append(budget_row<d>(before_.step, before_.time, total_, step_));
}

template <int d>
void SchemeBudget<d>::add_impulses(const OutsideForces<d>& outside, const Standing<d>& now,
                                   StateChange& state) {
  const StepChanges& by = outside.changes();
  BudgetPart &own = step_.part("internal force"), &integrator = step_.part("integrator");
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const Index i = places_[p];
    const double m = outside.mass()[static_cast<std::size_t>(i)];
    const Vec<3> v0 = in_space<d>(before_.v[p]), v1 = in_space<d>(now.v[p]);
    const Vec<3> x0 = in_space<d>(before_.x[p]), x1 = in_space<d>(now.x[p]);
    const Vec<3> from = at<d>(by.from, i), to = at<d>(by.to, i);
    const Vec<3> v = 0.5 * (from + to), x = 0.5 * (x0 + x1);
    push(m * at<d>(by.own, i), x, own);
    own.energy += m * v.dot(at<d>(by.own, i));
    if (outside.loads_body()) push(m * at<d>(by.loads, i), x, step_.part("loads"));
    if (!outside.contact().empty()) push(m * at<d>(by.contact, i), x, step_.part("contact"));
    if (outside.damps()) {
      push(m * (from - v0), x0, step_.part("damping"));
      push(m * (v1 - to), x1, step_.part("damping"));
    }
    integrator.angular += m * (x1 - x0).cross(v);
    state.add(m, x0, x1, v0, v1, v);
  }
}

/// Supports set velocities: what no other cause has done to a held component is theirs.
template <int d>
void SchemeBudget<d>::add_supports(const OutsideForces<d>& outside, const Standing<d>& now) {
  if (outside.held().empty()) return;
  const StepChanges& by = outside.changes();
  std::vector<std::size_t> particle(outside.mass().size());
  for (std::size_t p = 0; p < places_.size(); ++p) particle[static_cast<std::size_t>(places_[p])] = p;
  for (const auto& held : outside.held()) {
    const int k = held.component;
    const double others =
        at<d>(by.own, held.slot)[k] + at<d>(by.loads, held.slot)[k] + at<d>(by.contact, held.slot)[k];
    const auto i = static_cast<std::size_t>(held.slot);
    const double rest = by.to[k][held.slot] - by.from[k][held.slot] - others;
    const Vec<3> x = 0.5 * (in_space<d>(before_.x[particle[i]]) + in_space<d>(now.x[particle[i]]));
    push(outside.mass()[i] * rest * Vec<3>::Unit(k), x, step_.part("supports"));
  }
}

template <int d>
void SchemeBudget<d>::close_step(const OutsideForces<d>& outside, Standing<d> now) {
  for (auto& p : step_.parts) p = {p.name};
  StateChange state;
  add_impulses(outside, now, state);
  add_supports(outside, now);
  const OutsideWork &then = before_.works, &since = now.works;
  if (outside.loads_body()) step_.part("loads").energy = since.loads - then.loads;
  if (outside.damps()) step_.part("damping").energy = since.damping - then.damping;
  if (!outside.held().empty()) step_.part("supports").energy = since.supports - then.supports;
  if (!outside.contact().empty()) step_.part("contact").energy = since.contact - then.contact;
  set_gaps(sum_of(step_.parts), state, step_);
  // the work of the internal force goes into what the body stores; what is left is the integrator's
  step_.part("integrator").energy =
      std::exchange(step_.part("internal force").energy, 0) + now.stored - before_.stored;
  add_step(step_, total_);
  before_ = std::move(now);
  series_.append(budget_row<d>(before_.step, before_.time, total_, step_));
}

template class SchemeBudget<1>;
template class SchemeBudget<2>;
template class SchemeBudget<3>;

}  // namespace plumb
