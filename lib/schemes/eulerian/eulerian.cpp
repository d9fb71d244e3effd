#include "lib/schemes/eulerian/eulerian.hpp"

#include <algorithm>
#include <cmath>

#include "lib/schemes/point_fields.hpp"

namespace plumb {

template <int d>
Eulerian<d>::Eulerian(Specimen<d> specimen, EulerianOptions options, const Actions<d>& actions,
                      double damping, std::vector<RigidWall<d>> walls, const TouchOptions& touch)
    : specimen_(std::move(specimen)),
      options_(std::move(options)),
      law_(specimen_.law, specimen_.elastic, true, true, std::nullopt, name),
      h_(options_.beta * specimen_.cloud.spacing),
      kernel_(h_),
      neighbours_(2 * h_, options_.skin * specimen_.cloud.spacing, specimen_.cloud.body, PairsOf::one_body) {
  const Cloud<d>& cloud = specimen_.cloud;
  const Index n = cloud.size();
  outside_ = OutsideForces<d>(actions, cloud, Slots{n, 0, 0, 1}, {law_.density, damping});
  for (const double V : cloud.V) mass_.push_back(law_.density * V);
  if (!cloud.body.empty()) touching_ = touching_bodies<d>(cloud, specimen_.elastic, touch);
  if (!walls.empty() || touching_) {
    Contact<d> contact(std::move(walls), cloud.X, mass_, cloud.spacing / 2);
    if (touching_) contact.meet(cloud.body, touching_->step_limit(mass_));
    outside_.touch(std::move(contact));
  }
  x_ = cloud.X;
  v_.assign(x_.size(), Vec<d>::Zero());
  half_ = sum_ = v_;
  V_ = cloud.V;
  power_.assign(x_.size(), 0.0);
  damped_ = power_;
  if (options_.stiffness_share() > 0) stiff_ = power_;
  if (options_.printed()) shepard_ = power_;
  if (options_.diffusion > 0) rate_ = power_;
  M_.assign(x_.size(), Mat<d>::Zero());
  A_ = L_ = S_ = extra_ = M_;
  if (options_.artificial_stress > 0) repulsion_ = M_;
  near_.assign(x_.size(), 0);
  kick_ = make_field(d);
  unused_ = make_field(d);
  next_ = make_state();
  neighbours_.update(x_);
  sum_up();
  refuse_one_place<d>(*neighbours_.list(), x_, cloud.spacing);
  for (Index i = 0; i < n; ++i) require_span<d>(M_[i], i, x_[i]);
  singular_ = 0;
}

template <int d>
EulerianState<d> Eulerian<d>::make_state() const {
  State state;
  state.v = make_field(d);
  state.u = make_field(d);
  state.density = make_field(1);
  state.stress = make_field(d * d);
  state.plastic = make_field(static_cast<int>(law_.kept().size()));
  state.acceleration = make_field(d);
  state.force = make_field(d);
  if (options_.controls_hourglass()) state.hourglass = make_field(d);
  if (options_.has_viscosity()) state.viscous = make_field(d);
  if (keeps_F()) state.F = make_field(d * d);
  state.place = make_field(d);
  state.before = make_field(d * d);
  state.volume = make_field(1);
  state.anchors = make_field(outside_.contact().anchor_components());
  if (touching_) state.between = make_field(d);
  if (touching_ && touching_->rough()) state.slip = make_field(d);
  return state;
}

template <int d>
EulerianState<d> Eulerian<d>::start(const InitialMotion<d>& motion) {
  State state = make_state();
  for (std::size_t i = 0; i < motion.u.size(); ++i)
    set_vector<d>(state.u, static_cast<Index>(i), motion.u[i]);
  for (std::size_t i = 0; i < motion.v.size(); ++i)
    set_vector<d>(state.v, static_cast<Index>(i), motion.v[i]);
  outside_.start(state.u, state.v);
  outside_.contact().start(state.u, state.anchors);
  const Cloud<d>& cloud = specimen_.cloud;
  for (Index i = 0; i < count(); ++i) {
    state.density[0][i] = law_.density;
    store(law_.at_rest(motion.temperature_of(i)), state, i);
    set_tensor<d>(state.before, i, Mat<d>::Identity());
    state.volume[0][i] = cloud.V[i];
  }
  follow_reference(state);  // the body before it was deformed
  for (Index i = 0; i < count(); ++i) {
    x_[i] = cloud.X[i] + vector_at<d>(state.u, i);
    v_[i] = vector_at<d>(state.v, i);
  }
  for (Index i = 0; i < count(); ++i) {
    const Mat<d> F = reference_->gradient(x_, i);
    if (keeps_F()) set_tensor<d>(state.F, i, F);
    if (motion.u.empty()) continue;
    state.density[0][i] = law_.density / F.determinant();
    Point point = law_.at_rest();
    point.s = law_.deviator_of(F);
    law_.give_back(point, slowly, state.density[0][i]);
    store(point, state, i);
  }
  for (Index i = 0; i < count(); ++i) V_[i] = mass_[i] / state.density[0][i];
  if (neighbours_.update(x_)) {
    for (Index i = 0; i < count(); ++i) {
      set_tensor<d>(state.before, i, reference_->gradient(x_, i));
      state.volume[0][i] = V_[i];
      set_vector<d>(state.place, i, vector_at<d>(state.u, i));
    }
    rebuild_reference(state);
  }
  std::fill(extra_.begin(), extra_.end(), Mat<d>::Zero());
  sum_up();
  find_forces(state);
  press_bodies(state, 0);
  return state;
}

template <int d>
typename RateLaw<d>::Point Eulerian<d>::point_of(const State& state, Index i) const {
  return law_.recall(tensor_at<d>(state.stress, i), state.plastic, i);
}

template <int d>
void Eulerian<d>::store(const Point& point, State& state, Index i) const {
  set_tensor<d>(state.stress, i, point.s);
  law_.keep(point, state.plastic, i);
}

template <int d>
std::optional<Trouble> Eulerian<d>::find_trouble(const State& state) const {
  for (Index i = 0; i < count(); ++i) {
    for (int k = 0; k < d; ++k) {
      if (!std::isfinite(state.u[k][i])) return Trouble{i, "displacement", state.u[k][i]};
      if (!std::isfinite(state.v[k][i])) return Trouble{i, "velocity", state.v[k][i]};
    }
    if (!(state.density[0][i] > 0)) return Trouble{i, "density", state.density[0][i]};
  }
  return std::nullopt;
}

template <int d>
double Eulerian<d>::damage_of(const State& state, Index i) const {
  return state.plastic.components() > 3 ? state.plastic[3][i] : 0;
}

template <int d>
double Eulerian<d>::pressure_of(const State& state, Index i) const {
  return law_.pressure(state.density[0][i], damage_of(state, i));
}

template <int d>
double Eulerian<d>::wave_speed() const {
  return std::sqrt((law_.bulk + 4.0 / 3 * law_.shear) / law_.density);
}

template <int d>
double Eulerian<d>::young() const {
  return 9 * law_.bulk * law_.shear / (3 * law_.bulk + law_.shear);
}

/// The stiffness of hourglass control shortens the step from a factor of 4 on.
template <int d>
double Eulerian<d>::step_limit(const State& state) const {
  double stiffness = options_.stiffness();
  for (Index i = 0; i < count() && options_.xi_tension > 0; ++i)
    stiffness = std::max(stiffness, stiffness_of(state, i));
  const double own = options_.cfl * h_ / (wave_speed() * std::sqrt(std::max(1.0, stiffness / 4)));
  return outside_.contact().empty() ? own : std::min(own, outside_.contact().step_limit());
}

template <int d>
void Eulerian<d>::rebuild_reference(const State& state) {
  std::vector<Vec<d>> x(mass_.size());
  std::vector<double> V(mass_.size());
  for (Index i = 0; i < count(); ++i) {
    x[i] = specimen_.cloud.X[i] + vector_at<d>(state.place, i);
    V[i] = state.volume[0][i];
  }
  // neighbours that are found at the reference, so that the next search comes when it would have come
  neighbours_ = MovingNeighbours<d>(2 * h_, options_.skin * specimen_.cloud.spacing, specimen_.cloud.body,
                                    PairsOf::one_body);
  neighbours_.update(x);
  ++searches_;
  reference_.emplace(std::move(x), std::move(V), neighbours_.list(), kernel_);
}

template <int d>
void Eulerian<d>::follow_reference(const State& state) {
  bool same = reference_.has_value();
  for (Index i = 0; i < count() && same; ++i)
    same = reference_->x()[i] == Vec<d>(specimen_.cloud.X[i] + vector_at<d>(state.place, i)) &&
           reference_->V()[i] == state.volume[0][i];
  if (!same) rebuild_reference(state);
}

template class Eulerian<1>;
template class Eulerian<2>;
template class Eulerian<3>;

}  // namespace plumb
