#include <algorithm>
#include <cmath>

#include "lib/schemes/pair_row.hpp"
#include "lib/schemes/point_fields.hpp"
#include "lib/schemes/updated/updated.hpp"

/// One acoustic step as paper 002 has it, with its misprints mended: half a drift, a kick with the geometry
/// of the step's start or of the last advection step, rates with the new velocities, half a drift. THEORY
/// (17.1)-(17.4).
namespace plumb {

/// Takes the geometry of the sums to x_, V_ and B_: a new one, or the frozen one.
template <int d>
void Updated<d>::follow_geometry(State& state, double dt) {
  next_.age = state.age + dt;
  next_.life = state.life;
  const bool freezes = options_.geometry == "advection";
  if (freezes && state.age < state.life) {
    for_particles(count(), [&](Index i) {
      for (int k = 0; k < d; ++k) x_[i][k] = state.frozen[k][i];
      V_[i] = state.frozen[d][i];
    });
  } else {
    double square = 0;
    for (Index i = 0; i < count(); ++i) {
      V_[i] = mass_[i] / state.density[0][i];
      square = std::max(square, v_[i].squaredNorm());
    }
    next_.age = dt;
    if (freezes)
      next_.life = options_.advection_cfl * h_ / std::max(std::sqrt(square), *options_.reference_speed);
  }
  for (Index i = 0; i < count() && freezes; ++i) {
    for (int k = 0; k < d; ++k) next_.frozen[k][i] = x_[i][k];
    next_.frozen[d][i] = V_[i];
  }
  neighbours_.update(x_);
  for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) { M_[i] = row.minus_sum(row.r); });
  correct();
}

/// (16) with (17), and (19), as forces of pairs [N]; S_ holds the deviators that act.
template <int d>
void Updated<d>::printed_forces(const State& state) {
  const bool dissipates = options_.dissipation != "none", own_pressure = options_.misprinted("17");
  for_rows(pairs(), Seen::openings, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = Vec<d>::Zero();
    double heat = 0;
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> r = row.r_of(m);
      const double w = row.weight[m];
      const double here = impedance_[i], there = impedance_[j];
      double pressure =
          own_pressure ? pressure_[i] : (there * pressure_[i] + here * pressure_[j]) / (here + there);
      if (dissipates) {
        const double opening = row.opening[m] * row.per_r[m], z = joint(here, there);
        pressure -= z * opening;
        heat -= w * z * opening * opening * row.distance[m];
      }
      force += w * ((S_[i] + S_[j]) * r - 2 * pressure * r);
    }
    force_[i] = V_[i] * force;
    heat_[i] = V_[i] * heat;
  });
  if (options_.has_bonds())
    for_particles(count(), [&](Index i) { force_[i] += vector_at<d>(state.pull, i); });
}

/// Velocity gradient (20) and rate of the density (15), with the velocities v_.
template <int d>
void Updated<d>::printed_rates(State& next, double dt) {
  counts_ = {};
  for_rows(pairs(), Seen::velocities, [&](Index i, const PairRow<d>& row) {
    near_[i] = static_cast<std::int32_t>(row.count);
    const Mat<d> G = row.minus_sum(row.v), L = G * B_[i];
    set_tensor<d>(next.gradient, i, L);
    // the sum of (15) is not corrected: -rho tr G
    next.density_rate[0][i] = -next.density[0][i] * G.trace();
    Point point = point_of(next, i);
    law_.advance(point, L, dt, next.density[0][i]);
    store(point, next, i);
    yield_ratio_[i] = point.yield_ratio;
    next.density[0][i] += 0.5 * dt * next.density_rate[0][i];
    const Mat<d> I = Mat<d>::Identity(), half = 0.5 * dt * L;
    const Mat<d> F = (I - half).inverse() * ((I + half) * tensor_at<d>(next.F, i));
    set_tensor<d>(next.F, i, std::pow(law_.density / next.density[0][i] / F.determinant(), 1.0 / d) * F);
  });
  for (Index i = 0; i < count(); ++i) {
    counts_.pairs += near_[i];
    counts_.most = std::max<Index>(counts_.most, near_[i]);
  }
}

/// What has been summed up, turned (34), (42), and its increment (28), (43), (46): THEORY (17.4).
template <int d>
void Updated<d>::sum_up(const State& state, State& next, double dt) {
  const bool vector = options_.form == "gno" && options_.penalty == "vector", linear = options_.form == "gno";
  const bool twice = options_.misprinted("49");
  Mat<d> mean = Mat<d>::Zero();
  for_particles(count(), [&](Index i) {
    S_[i] = tensor_at<d>(next.gradient, i);
    const Mat<d> before = tensor_at<d>(state.gradient, i);
    M_[i] = rotation_of<d>(0.5 * (before - before.transpose()), dt);
  });
  for (Index i = 0; i < count(); ++i) mean += M_[i] / static_cast<double>(count());
  const double modulus = bond_modulus();
  for_rows(pairs(), Seen::openings, [&](Index i, const PairRow<d>& row) {
    Vec<d> sum = Vec<d>::Zero();
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> r = row.r_of(m), v = row.v_of(m);
      const double kept = options_.yield_ratio ? 0.5 * (yield_ratio_[i] + yield_ratio_[j]) : 1;
      // e.v/r grad W = w (e.v) e, and v/r dW/dr = w v
      const Vec<d> missed = linear ? Vec<d>(v - 0.5 * ((S_[i] + S_[j]) * r)) : v;
      const double along = missed.dot(r) * row.per_r[m] * row.per_r[m];
      sum += kept * row.weight[m] * (vector ? missed : Vec<d>(along * r));
    }
    Vec<d> pull = vector_at<d>(state.pull, i);
    if (options_.rotation == "own") pull = M_[i] * pull;
    if (options_.rotation == "mean") pull = mean * pull;
    set_vector<d>(next.pull, i, pull + (twice ? V_[i] : 1) * modulus * dt * V_[i] * sum);
  });
}

template <int d>
std::optional<Trouble> Updated<d>::advance_printed(State& state, double dt) {
  const double middle = state.time + 0.5 * dt, c0 = law_.sound_speed();
  follow_geometry(state, dt);
  for_particles(count(), [&](Index i) {
    next_.density[0][i] = state.density[0][i] + 0.5 * dt * state.density_rate[0][i];
    pressure_[i] = law_.pressure(next_.density[0][i]);
    impedance_[i] = next_.density[0][i] * c0;
    const Point point = point_of(state, i);
    store(point, next_, i);
    set_tensor<d>(next_.F, i, tensor_at<d>(state.F, i));
    S_[i] = options_.form == "eno" ? Mat<d>(Mat<d>::Zero()) : point.s;
  });
  printed_forces(state);
  for_particles(count(), [&](Index i) { set_vector<d>(acceleration_, i, force_[i] / mass_[i]); });
  outside_.add_loads(middle, &state.F, acceleration_);
  outside_.hold(middle, dt, state.v, acceleration_, unused_);
  for_particles(count(), [&](Index i) {
    const Vec<d> v = v_[i] + dt * vector_at<d>(acceleration_, i);
    set_vector<d>(next_.u, i, vector_at<d>(state.u, i) + 0.5 * dt * (v_[i] + v));
    set_vector<d>(next_.v, i, v);
    if (options_.dissipation != "none") next_.heat[0][i] = state.heat[0][i] + dt * heat_[i];
  });
  next_.time = state.time + dt;
  next_.step = state.step + 1;
  next_.last_step = dt;
  outside_.end_step(next_.time, dt, next_.u, next_.v, next_.outside);
  for_particles(count(), [&](Index i) { v_[i] = vector_at<d>(next_.v, i); });
  printed_rates(next_, dt);
  if (options_.has_bonds()) sum_up(state, next_, dt);
  return find_trouble(next_);
}

template std::optional<Trouble> Updated<1>::advance_printed(UpdatedState<1>&, double);
template std::optional<Trouble> Updated<2>::advance_printed(UpdatedState<2>&, double);
template std::optional<Trouble> Updated<3>::advance_printed(UpdatedState<3>&, double);

}  // namespace plumb
