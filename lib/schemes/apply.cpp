#include "lib/schemes/apply.hpp"

#include "lib/material/material.hpp"

namespace plumb {

template <int d>
AppliedActions<d>::AppliedActions(const Actions<d>& actions, const Cloud<d>& cloud, const Slots& slots)
    : actions_(actions), count_(slots.count()) {
  for (std::size_t n = 0; n < actions.surface.size(); ++n)
    for (const LoadedPlace<d>& place : actions.surface[n].places) {
      surface_.push_back({slots.of(place.particle), n, place.at, place.normal(),
                          place.size() / cloud.V[static_cast<std::size_t>(place.particle)]});
      follows_ = follows_ || static_cast<bool>(actions.surface[n].pressure);
    }
  for (std::size_t n = 0; n < actions.held.size(); ++n)
    for (const HeldPlace<d>& place : actions.held[n].places)
      held_.push_back({slots.of(place.particle), place.component, n, place.at});
  if (actions.body_forces.empty()) return;
  X_ = cloud.X;
  for (Index i = 0; i < cloud.size(); ++i) slot_.push_back(slots.of(i));
  for (const BodyForce<d>& body : actions.body_forces) {
    if (!body.steady) continue;
    if (!steady_.components()) steady_ = Field(d, count_, 0);
    for (std::size_t i = 0; i < X_.size(); ++i)
      set_vector<d>(steady_, slot_[i], vector_at<d>(steady_, slot_[i]) + body.per_volume(X_[i], 0));
  }
}

template <int d>
void AppliedActions<d>::add_loads(double time, const Field* F, double factor, Field& to) const {
  for (int k = 0; k < steady_.components(); ++k)
    for (Index i = 0; i < count_; ++i) to[k][i] += factor * steady_[k][i];
  const auto add = [&](Index slot, const Vec<d>& force) {
    for (int k = 0; k < d; ++k) to[k][slot] += factor * force[k];
  };
  for (const BodyForce<d>& body : actions_.body_forces) {
    if (body.steady) continue;
#pragma omp parallel for schedule(static) if (count_ > 4096)
    for (Index i = 0; i < static_cast<Index>(X_.size()); ++i)
      add(slot_[static_cast<std::size_t>(i)], body.per_volume(X_[static_cast<std::size_t>(i)], time));
  }
  for (const SurfacePlace& place : surface_) {
    const SurfaceLoad<d>& load = actions_.surface[place.load];
    Vec<d> t;
    if (load.traction) {
      t = load.traction(place.at, place.normal, time);
    } else {
      Mat<d> gradient;
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) gradient(a, b) = (*F)[a * d + b][place.slot];
      t = -load.pressure(place.at, time) * (cofactor<d, double>(gradient) * place.normal);  // Nanson
    }
    add(place.slot, place.per_volume * t);
  }
}

template <int d>
void AppliedActions<d>::hold(double time, const Field& v, Field& v_rate, Field& u_rate) const {
  for (const HeldSlot& place : held_) {
    const Held<d>& held = actions_.held[place.held];
    v_rate[place.component][place.slot] =
        held.steady ? 0 : held.motion(place.at, place.component, time).acceleration;
    u_rate[place.component][place.slot] = v[place.component][place.slot];
  }
}

template <int d>
void AppliedActions<d>::impose(double time, Field& u, Field& v, bool all) const {
  for (const HeldSlot& place : held_) {
    const Held<d>& held = actions_.held[place.held];
    if (held.steady && !all) continue;
    const HeldMotion motion = held.motion(place.at, place.component, time);
    v[place.component][place.slot] = motion.velocity;
    if (motion.displacement) u[place.component][place.slot] = *motion.displacement;
  }
}

template class AppliedActions<1>;
template class AppliedActions<2>;
template class AppliedActions<3>;

}  // namespace plumb
