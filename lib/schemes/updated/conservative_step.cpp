#include <algorithm>
#include <cmath>

#include "lib/schemes/pair_row.hpp"
#include "lib/schemes/point_fields.hpp"
#include "lib/schemes/updated/updated.hpp"

/// One step of the balance that keeps both momenta: leapfrog with the geometry of x^{n+1/2} for the forces
/// and of x^{n+1} for the rates. THEORY (17.5)-(17.8).
namespace plumb {

template <int d>
typename Updated<d>::Moved Updated<d>::moved(const State& state, Index i, double tau) const {
  const Mat<d> L = tensor_at<d>(state.gradient, i);
  Moved now{point_of(state, i), state.density[0][i] * std::exp(-tau * L.trace()), {}};
  law_.advance(now.point, L, tau, now.density);
  // Cayley's map turns exactly where L is a spin; the volume is that of the density
  const Mat<d> I = Mat<d>::Identity(), half = 0.5 * tau * L;
  const Mat<d> F = (I - half).inverse() * ((I + half) * tensor_at<d>(state.F, i));
  now.F = std::pow(law_.density / now.density / F.determinant(), 1.0 / d) * F;
  return now;
}

/// The stretch of every pair beyond its velocity gradients; a pair that leaves the reach forgets it.
template <int d>
void Updated<d>::stretch_bonds(const State& state, const PairHistory& before, double tau) {
  PairHistory& after = next_.bonds;
  after.list = before.list;
  after.value.resize(before.value.size());
  for_particles(count(), [&](Index i) { S_[i] = tensor_at<d>(state.gradient, i); });
  const bool linear = options_.form == "gno";
  std::fill(after.value.begin(), after.value.end(), 0.0);
  for_rows(pairs(), Seen::openings, [&](Index i, const PairRow<d>& row) {
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> r = row.r_of(m);
      double rate = row.opening[m];
      if (linear) rate -= 0.5 * r.dot((S_[i] + S_[j]) * r);
      const double kept = options_.yield_ratio ? 0.5 * (yield_ratio_[i] + yield_ratio_[j]) : 1;
      after.value[row.place[m]] = kept * (before.value[row.place[m]] + tau * rate * row.per_r[m]);
    }
  });
}

/// What the bonds of a particle add to its stress, since its velocity gradient is in their stretch: THEORY
/// (17.11).
template <int d>
Mat<d> Updated<d>::reaction(const PairHistory& bonds, const PairRow<d>& row) const {
  double* const share = row.spare;
  for (Index m = 0; m < row.count; ++m) share[m] = bonds.value[row.place[m]];
  for (Index m = row.count; m < row.padded; ++m) share[m] = 0;
#pragma omp simd
  for (Index m = 0; m < row.padded; ++m) share[m] *= row.weight[m] / row.distance[m];
  return 0.5 * bond_modulus() * row.sum_of_squares(share);
}

/// Force on every particle at x_ [N], THEORY (17.6): S_ holds sigma B. Without dissipation
/// impedance_ is not read.
template <int d>
void Updated<d>::conservative_forces(const PairHistory& bonds, bool dissipates) {
  const double modulus = bond_modulus();
  for_rows(pairs(), Seen::openings, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = Vec<d>::Zero(), sum = Vec<d>::Zero();
    double heat = 0;
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> r = row.r_of(m), wr = row.weight[m] * r;
      double along = modulus > 0 ? modulus * bonds.value[row.place[m]] : 0;
      if (dissipates) {
        const double opening = row.opening[m], z = joint(impedance_[i], impedance_[j]);
        along += 2 * z * opening;
        heat -= row.weight[m] * z * opening * opening * row.per_r[m];
      }
      sum += wr;
      force += S_[j] * wr + (along * row.per_r[m]) * wr;
    }
    force_[i] = V_[i] * (force + S_[i] * sum);
    heat_[i] = V_[i] * heat;
  });
}

/// Accelerations by forces between bodies, and by the couples that friction puts on the stress: THEORY (19.6).
template <int d>
void Updated<d>::press_bodies(const State& state, double apart) {
  for_particles(count(), [&](Index i) { S_[i] = tensor_at<d>(state.gradient, i); });
  touching_->find(x_, {v_, S_, apart}, next_.slip);
  const std::vector<Vec<d>>& forces = touching_->forces();
  if (const auto* couples = touching_->couples()) {
    for_particles(count(), [&](Index i) { S_[i] = (*couples)[i] / V_[i] * B_[i]; });
    for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) {
      set_vector<d>(between_, i, (forces[i] + V_[i] * row.adjoint_sum(S_, i)) / mass_[i]);
    });
  } else {
    for_particles(count(), [&](Index i) { set_vector<d>(between_, i, forces[i] / mass_[i]); });
  }
  outside_.add_between(between_, acceleration_);
}

template <int d>
void Updated<d>::balance(double time, bool still, const State& state, double apart) {
  const bool bonds_are_shear = options_.form == "eno", reacts = options_.bonds_react();
  for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) {
    M_[i] = row.minus_sum(row.r);
    if (reacts) S_[i] = reaction(next_.bonds, row);
  });
  correct();
  for_particles(count(), [&](Index i) {
    Mat<d> stress = -law_.pressure(next_.density[0][i]) * Mat<d>::Identity();
    if (!bonds_are_shear) stress += tensor_at<d>(next_.stress, i);
    if (reacts) stress += S_[i];
    S_[i] = stress * B_[i];
  });
  conservative_forces(next_.bonds, !still && options_.dissipation != "none");
  for_particles(count(), [&](Index i) { set_vector<d>(acceleration_, i, force_[i] / mass_[i]); });
  outside_.add_loads(time, &next_.F, acceleration_);
  outside_.add_contact(time, x_, next_.anchors, acceleration_);
  if (touching_) press_bodies(state, apart);
}

template <int d>
std::optional<OpenAcceleration> Updated<d>::open(const State& state, bool still) {
  if (load(state)) return std::nullopt;
  neighbours_.update(x_);
  const double c0 = law_.sound_speed();
  for_particles(count(), [&](Index i) {
    const Moved now = at_end_of_step(state, i);
    store(now.point, next_, i);
    next_.density[0][i] = now.density;
    set_tensor<d>(next_.F, i, now.F);
    yield_ratio_[i] = now.point.yield_ratio;
    V_[i] = mass_[i] / now.density;
    impedance_[i] = now.density * c0;
  });
  if (bond_modulus() > 0) {
    PairHistory kept = state.bonds;
    kept.move_to(neighbours_.list());
    stretch_bonds(state, kept, 0.5 * state.last_step);
  }
  next_.anchors = state.anchors;
  next_.slip = state.slip;
  balance(state.time, still, state, 0.5 * state.last_step);
  return OpenAcceleration{acceleration_, outside_.loads()};
}

template <int d>
std::optional<Trouble> Updated<d>::advance_conservative(State& state, double dt) {
  const double tau = 0.5 * (state.last_step + dt), middle = state.time + 0.5 * dt;
  neighbours_.update(x_);
  if (bond_modulus() > 0) state.bonds.move_to(neighbours_.list());
  const double c0 = law_.sound_speed();
  for_particles(count(), [&](Index i) {
    const Moved now = moved(state, i, tau);
    store(now.point, next_, i);
    next_.density[0][i] = now.density;
    set_tensor<d>(next_.F, i, now.F);
    yield_ratio_[i] = now.point.yield_ratio;
    V_[i] = mass_[i] / now.density;
    impedance_[i] = now.density * c0;
  });
  if (bond_modulus() > 0) stretch_bonds(state, state.bonds, tau);
  for_particles(count(), [&](Index i) { x_[i] += 0.5 * dt * v_[i]; });
  neighbours_.update(x_);
  if (bond_modulus() > 0) next_.bonds.move_to(neighbours_.list());
  balance(middle, false, state, tau);
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
  if (auto trouble = load(next_)) return trouble;
  neighbours_.update(x_);
  differentiate(next_);
  return std::nullopt;
}

#define PLUMBLINE_INSTANTIATE(d)                                                             \
  template Updated<d>::Moved Updated<d>::moved(const UpdatedState<d>&, Index, double) const; \
  template std::optional<OpenAcceleration> Updated<d>::open(const UpdatedState<d>&, bool);   \
  template std::optional<Trouble> Updated<d>::advance_conservative(UpdatedState<d>&, double);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
