#include "lib/schemes/outside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace plumb {
namespace {

/// The held components, each once, in the order of slots; the later one of two boundaries has it.
template <int d>
std::vector<typename OutsideForces<d>::Place> places_of(const std::vector<Held<d>>& boundaries,
                                                        const Slots& slots) {
  std::vector<typename OutsideForces<d>::Place> all;
  for (std::size_t n = boundaries.size(); n-- > 0;) {
    const Held<d>& held = boundaries[n];
    for (const HeldPlace<d>& place : held.places)
      all.push_back({slots.of(place.particle), place.component, n, place.at,
                     !held.steady || held.motion(place.at, place.component, 0).velocity != 0});
  }
  const auto key = [](const auto& place) { return std::tuple(place.slot, place.component); };
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// to += factor * from, for as many components as `to` has.
void add(double factor, const Field& from, Index count, Field& to) {
  for (int k = 0; k < to.components(); ++k)
    for (Index i = 0; i < count; ++i) to[k][i] += factor * from[k][i];
}

void clear(Index count, Field& field) {
  for (int k = 0; k < field.components(); ++k) std::fill_n(field[k], count, 0.0);
}

}  // namespace

template <int d>
OutsideForces<d>::OutsideForces(const Actions<d>& actions, const Cloud<d>& cloud, const Slots& slots,
                                const Medium& medium)
    : applied_(actions, cloud, slots),
      boundaries_(actions.held),
      held_(places_of<d>(actions.held, slots)),
      mass_(static_cast<std::size_t>(slots.count()), 0.0),
      medium_(medium),
      loaded_(actions.has_loads()),
      moved_(std::any_of(held_.begin(), held_.end(), [](const Place& place) { return place.moves; })) {
  for (Held<d>& boundary : boundaries_) std::vector<HeldPlace<d>>().swap(boundary.places);
  for (Index i = 0; i < cloud.size(); ++i)
    mass_[static_cast<std::size_t>(slots.of(i))] = medium.density * cloud.V[static_cast<std::size_t>(i)];
  if (loaded_) loads_ = changes_.loads = Field(d, slots.count(), 0);
  if (moved_) by_others_.assign(held_.size(), 0.0);
}

template <int d>
void OutsideForces<d>::touch(Contact<d> contact) {
  contact_ = std::move(contact);
  if (!contact_.empty()) changes_.contact = Field(d, count(), 0);
}

template <int d>
void OutsideForces<d>::follow_changes() {
  followed_ = true;
  changes_.own = Field(d, count(), 0);
}

template <int d>
double OutsideForces<d>::work_of(const Field& change, const Field& v) const {
  double work = 0;
  for (int k = 0; k < change.components(); ++k)
    for (Index i = 0; i < count(); ++i)
      work += mass_[i] * change[k][i] * 0.5 * (changes_.from[k][i] + v[k][i]);
  return work;
}

template <int d>
double OutsideForces<d>::damp(double change, Field& v) const {
  // held components stay as they are; all others are damped
  std::vector<double> kept;
  for (const Place& place : held_) kept.push_back(v[place.component][place.slot]);
  double twice = 0;
  for (int k = 0; k < d; ++k)
    for (Index i = 0; i < count(); ++i) {
      twice += mass_[i] * v[k][i] * v[k][i];
      v[k][i] += change * v[k][i];
    }
  for (std::size_t n = 0; n < held_.size(); ++n) {
    const auto& [slot, component, boundary, at, moves] = held_[n];
    twice -= mass_[slot] * kept[n] * kept[n];
    v[component][slot] = kept[n];
  }
  return change * (1 + 0.5 * change) * twice;
}

template <int d>
void OutsideForces<d>::damp_half(double dt, Field& v, OutsideWork& work) const {
  if (!damps()) return;
  const double change = std::expm1(-0.5 * medium_.damping * dt);
  double held = 0;  // what is taken off held components, their supports put on again
  for (const Place& place : held_) {
    const double speed = v[place.component][place.slot];
    held -= mass_[place.slot] * 0.5 * medium_.damping * dt * speed * speed;
  }
  work.damping += damp(change, v) + held;
  work.supports -= held;
}

template <int d>
void OutsideForces<d>::begin_step(double dt, Field& v, OutsideWork& work) {
  damp_half(dt, v, work);
  if (!loaded_ && !moved_ && !followed_ && contact_.empty()) return;
  changes_.from = v;
  clear(count(), changes_.loads);
  clear(count(), changes_.contact);
  clear(count(), changes_.own);
  std::fill(by_others_.begin(), by_others_.end(), 0.0);
}

template <int d>
void OutsideForces<d>::add_loads(double time, const Field* F, Field& v_rate) {
  if (!loaded_) return;
  for (int k = 0; k < d; ++k)
    for (Index i = 0; i < count(); ++i) loads_[k][i] = -v_rate[k][i];
  applied_.add_loads(time, F, 1 / medium_.density, v_rate);
  for (int k = 0; k < d; ++k)
    for (Index i = 0; i < count(); ++i) loads_[k][i] += v_rate[k][i];
}

/// From the change by all forces: that by those that are not the body's own.
template <int d>
void OutsideForces<d>::subtract_others(double weight) {
  for (const Field* others : std::array{&std::as_const(loads_), &contact_.acceleration()})
    for (int k = 0; k < others->components(); ++k)
      for (Index i = 0; i < count(); ++i) changes_.own[k][i] -= weight * (*others)[k][i];
}

template <int d>
void OutsideForces<d>::hold(double time, double weight, const Field& v, Field& v_rate, Field& u_rate) {
  if (weight != 0) {
    add(weight, loads_, count(), changes_.loads);
    add(weight, contact_.acceleration(), count(), changes_.contact);
    add(weight, v_rate, count(), changes_.own);
    if (followed_) subtract_others(weight);
    for (std::size_t n = 0; n < by_others_.size(); ++n)
      by_others_[n] += weight * v_rate[held_[n].component][held_[n].slot];
  }
  applied_.hold(time, v, v_rate, u_rate);
}

template <int d>
void OutsideForces<d>::end_step(double time, double dt, Field& u, Field& v, OutsideWork& work) {
  applied_.impose(time, u, v, false);
  work.loads += work_of(changes_.loads, v);
  work.contact += work_of(changes_.contact, v);
  double by_supports = 0;
  for (std::size_t n = 0; n < by_others_.size(); ++n) {
    const auto& [slot, component, boundary, at, moves] = held_[n];
    const double from = changes_.from[component][slot], to = v[component][slot];
    by_supports += mass_[slot] * (to - from - by_others_[n]) * 0.5 * (from + to);
  }
  work.supports += by_supports;
  if (followed_) changes_.to = v;
  damp_half(dt, v, work);
  if (work.rest_rate > 0) damp(std::expm1(-work.rest_rate * dt), v);
}

template <int d>
std::vector<NamedEnergy> OutsideForces<d>::named(const OutsideWork& work) const {
  std::vector<NamedEnergy> works;
  if (loaded_) works.push_back({"loads", work.loads});
  if (damps()) works.push_back({"damping", work.damping});
  if (moved_) works.push_back({"supports", work.supports});
  if (!contact_.empty()) works.push_back({"contact", work.contact});
  return works;
}

template <int d>
std::vector<BoundaryForce<d>> OutsideForces<d>::reactions(double time, const OpenAcceleration& open,
                                                          const Field& v) const {
  std::vector<BoundaryForce<d>> forces = no_reactions();
  for (const Place& place : held_) {
    const Held<d>& boundary = boundaries_[place.boundary];
    const double prescribed =
        boundary.steady ? 0 : boundary.motion(place.at, place.component, time).acceleration;
    const double without =
        open.all[place.component][place.slot] - medium_.damping * v[place.component][place.slot];
    forces[place.boundary].force[place.component] += mass_[place.slot] * (prescribed - without);
  }
  for (std::size_t n = 0; n < contact_.walls().size(); ++n)
    forces[boundaries_.size() + n].force = contact_.force(n);
  return forces;
}

template <int d>
std::vector<BoundaryForce<d>> OutsideForces<d>::no_reactions() const {
  std::vector<BoundaryForce<d>> forces;
  for (const Held<d>& boundary : boundaries_) forces.push_back({boundary.name, Vec<d>::Zero()});
  for (const RigidWall<d>& wall : contact_.walls()) forces.push_back({wall.name, Vec<d>::Zero()});
  return forces;
}

template class OutsideForces<1>;
template class OutsideForces<2>;
template class OutsideForces<3>;

}  // namespace plumb
