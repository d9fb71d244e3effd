#include <algorithm>
#include <cmath>

#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/point_fields.hpp"
#include "lib/schemes/tensors.hpp"

/// One step: half a kick, the drift, rates and forces at the new places, half a kick. THEORY (18.5), (18.6).
namespace plumb {

template <int d>
void Eulerian<d>::find_neighbours(const State& state) {
  const bool aged = options_.rereference > 0 && (state.step + 1) % options_.rereference == 0;
  // a list that is not good for x_ any more makes the reference of (30) new, too
  if (!neighbours_.update(x_) && !aged) {
    for (Index i = 0; i < count(); ++i) {
      set_vector<d>(next_.place, i, vector_at<d>(state.place, i));
      set_tensor<d>(next_.before, i, tensor_at<d>(state.before, i));
      next_.volume[0][i] = state.volume[0][i];
    }
    return;
  }
  for_particles(count(), [&](Index i) {
    set_vector<d>(next_.place, i, vector_at<d>(next_.u, i));
    set_tensor<d>(next_.before, i, reference_->gradient(x_, i) * tensor_at<d>(state.before, i));
    next_.volume[0][i] = mass_[i] / state.density[0][i];
  });
  rebuild_reference(next_);
}

template <int d>
void Eulerian<d>::sum_up() {
  const bool printed = options_.printed();
  const double own = kernel_.value(0);
  for_rows(pairs(), Seen::velocities, [&](Index i, const PairRow<d>& row) {
    M_[i] = row.minus_sum(row.r);
    A_[i] = row.minus_sum(row.v);
    near_[i] = static_cast<std::int32_t>(row.count);
    if (!printed) return;
    double S = own * V_[i];
    for (Index m = 0; m < row.count; ++m) S += V_[row.other[m]] * kernel_.value(row.distance[m]);
    shepard_[i] = S;
  });
  counts_ = {};
  for (Index i = 0; i < count(); ++i) {
    L_[i] = correction<d>(M_[i]);
    A_[i] = A_[i] * L_[i];
    singular_ += L_[i] == Mat<d>::Zero();
    counts_.pairs += near_[i];
    counts_.most = std::max<Index>(counts_.most, near_[i]);
  }
}

template <int d>
void Eulerian<d>::diffuse(const State& state) {
  const double factor = -2 * options_.diffusion * h_ * law_.sound_speed();
  for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) {
    double sum = 0;
    for (Index m = 0; m < row.count; ++m)
      sum += row.weight[m] * (state.density[0][row.other[m]] - state.density[0][i]);
    rate_[i] = factor * sum;
  });
}

template <int d>
void Eulerian<d>::follow_rates(const State& state, double dt) {
  if (options_.diffusion > 0) diffuse(state);
  const bool damps = options_.damping == "objective", diffuses = options_.diffusion > 0;
  for_particles(count(), [&](Index i) {
    const Mat<d> I = Mat<d>::Identity(), L = dt * A_[i];
    const Mat<d> increment = L * (I - 0.5 * L).inverse();  // with respect to the middle of the step
    const double swell = 0.5 * increment.trace(), before = state.density[0][i];
    next_.density[0][i] = before * ((1 - swell) / (1 + swell)) + (diffuses ? dt * rate_[i] : 0);
    Point point = point_of(state, i);
    const Mat<d> turned = law_.advance_by(point, increment, dt, next_.density[0][i]);
    store(point, next_, i);
    const double p0 = pressure_of(state, i), p1 = pressure_of(next_, i);
    if (damps) extra_[i] = 0.5 * (point.s - turned - (p1 - p0) * I);
    const Mat<d> mean = 0.5 * (turned + point.s - (p0 + p1) * I);
    power_[i] = V_[i] * double_dot<d>(mean, increment);
    damped_[i] = damps ? V_[i] * double_dot<d>(extra_[i], increment) : 0;
    if (keeps_F()) set_tensor<d>(next_.F, i, reference_->gradient(x_, i) * tensor_at<d>(next_.before, i));
  });
  for (Index i = 0; i < count(); ++i) {
    next_.work.stress += power_[i];
    next_.work.damping += damped_[i];
  }
}

template <int d>
void Eulerian<d>::kick(const State& state, double half) {
  add_outside(state, next_.anchors);
  outside_.hold(state.time, half, next_.v, kick_, unused_);
  for_particles(count(), [&](Index i) {
    set_vector<d>(next_.v, i, vector_at<d>(next_.v, i) + half * vector_at<d>(kick_, i));
  });
}

template <int d>
void Eulerian<d>::count_work(const State& state, const Field& from, double half) {
  const auto work_of = [&](const Field& before, const Field& after) {
    double sum = 0;
    for (int k = 0; k < before.components(); ++k)
      for (Index i = 0; i < count(); ++i)
        sum += (before[k][i] + after[k][i]) * 0.5 * (from[k][i] + next_.v[k][i]);
    return half * sum;
  };
  next_.work.force += work_of(state.force, next_.force);
  next_.work.hourglass += work_of(state.hourglass, next_.hourglass);
  next_.work.viscosity += work_of(state.viscous, next_.viscous);
}

template <int d>
std::optional<Trouble> Eulerian<d>::advance(State& state, double dt) {
  follow_reference(state);
  const double half = 0.5 * dt, time = state.time + dt;
  next_.work = state.work;
  next_.outside = state.outside;
  next_.v = state.v;
  next_.anchors = state.anchors;
  next_.slip = state.slip;
  outside_.begin_step(dt, next_.v, next_.outside);
  const Field from = next_.v;
  kick(state, half);
  for_particles(count(), [&](Index i) {
    half_[i] = vector_at<d>(next_.v, i);
    set_vector<d>(next_.u, i, vector_at<d>(state.u, i) + dt * half_[i]);
    next_.density[0][i] = state.density[0][i];
    V_[i] = mass_[i] / state.density[0][i];
  });
  outside_.impose(time, next_.u, unused_);
  for_particles(count(), [&](Index i) {
    x_[i] = specimen_.cloud.X[i] + vector_at<d>(next_.u, i);
    v_[i] = half_[i];
    if (options_.damping == "extrapolated") v_[i] += half * vector_at<d>(kick_, i);
  });
  if (auto trouble = find_trouble(next_)) return trouble;
  find_neighbours(state);
  sum_up();
  follow_rates(state, dt);
  if (auto trouble = find_trouble(next_)) return trouble;
  v_ = half_;
  next_.time = time;
  next_.step = state.step + 1;
  find_forces(next_);
  press_bodies(next_, dt);
  kick(next_, half);
  outside_.impose(time, unused_, next_.v);
  count_work(state, from, half);
  outside_.end_step(time, dt, unused_, next_.v, next_.outside);
  std::swap(state, next_);
  return std::nullopt;
}

#define PLUMBLINE_INSTANTIATE(d)                                                        \
  template void Eulerian<d>::find_neighbours(const EulerianState<d>&);                  \
  template void Eulerian<d>::sum_up();                                                  \
  template void Eulerian<d>::diffuse(const EulerianState<d>&);                          \
  template void Eulerian<d>::follow_rates(const EulerianState<d>&, double);             \
  template void Eulerian<d>::kick(const EulerianState<d>&, double);                     \
  template void Eulerian<d>::count_work(const EulerianState<d>&, const Field&, double); \
  template std::optional<Trouble> Eulerian<d>::advance(EulerianState<d>&, double);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
