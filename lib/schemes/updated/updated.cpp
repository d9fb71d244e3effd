#include "lib/schemes/updated/updated.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/schemes/pair_row.hpp"
#include "lib/schemes/point_fields.hpp"

namespace plumb {
template <int d>
Updated<d>::Updated(Specimen<d> specimen, UpdatedOptions options, const Actions<d>& actions, double damping,
                    std::vector<RigidWall<d>> walls, const TouchOptions& touch)
    : specimen_(std::move(specimen)),
      options_(std::move(options)),
      law_(specimen_.law, specimen_.elastic, options_.deviator == "plane-strain",
           options_.stress_update == "jaumann", options_.tension_limit),
      h_(options_.beta * specimen_.cloud.spacing),
      slope_(wendland_slope<d>(h_)),
      neighbours_(2 * h_, options_.skin * specimen_.cloud.spacing, specimen_.cloud.body, PairsOf::one_body) {
  require_consistent(options_);
  const Cloud<d>& cloud = specimen_.cloud;
  if (options_.geometry == "advection" && !options_.reference_speed)
    throw InputError("geometry = \"advection\" without reference_speed",
                     "a body at rest would keep its geometry for ever (22)",
                     "add [updated] reference_speed, the greatest speed that is expected");
  if (law_.yields() && options_.form == "eno")
    throw InputError("form = \"eno\" with a yield stress", "its force does not see the stress",
                     "use form = \"gno\"");
  if (law_.johnson_cook() && law_.johnson_cook()->damages())
    throw InputError("scheme = \"updated\" with damage_1",
                     "a failed particle of that scheme would bear tension",
                     "leave damage_1 out, or use scheme = \"eulerian\"");
  const Index n = cloud.size();
  outside_ = OutsideForces<d>(actions, cloud, Slots{n, 0, 0, 1}, {law_.density, damping});
  for (const double V : cloud.V) mass_.push_back(law_.density * V);
  if (!cloud.body.empty()) {
    if (!options_.conservative())
      throw InputError("several bodies with balance = \"printed\"",
                       "its geometry may be that of steps before", "use balance = \"conservative\"");
    touching_ = touching_bodies<d>(cloud, specimen_.elastic, touch);
    between_ = make_field(d);
  }
  if (!walls.empty() || touching_) {
    Contact<d> contact(std::move(walls), cloud.X, mass_, cloud.spacing / 2);
    if (touching_) contact.meet(cloud.body, touching_->step_limit(mass_));
    outside_.touch(std::move(contact));
  }
  x_ = cloud.X;
  v_.assign(x_.size(), Vec<d>::Zero());
  force_ = v_;
  V_ = cloud.V;
  impedance_.assign(x_.size(), 0.0);
  pressure_ = heat_ = impedance_;
  yield_ratio_.assign(x_.size(), 1.0);
  M_.assign(x_.size(), Mat<d>::Zero());
  B_ = S_ = M_;
  near_.assign(x_.size(), 0);
  acceleration_ = make_field(d);
  unused_ = make_field(d);
  next_ = make_state();
  neighbours_.update(x_);
  for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) { M_[i] = row.minus_sum(row.r); });
  refuse_one_place<d>(*neighbours_.list(), x_, cloud.spacing);
  for (Index i = 0; i < n; ++i) {
    require_span<d>(M_[i], i, x_[i]);
    least_det_.push_back(options_.guard * M_[i].determinant());
  }
}

template <int d>
UpdatedState<d> Updated<d>::make_state() const {
  State state;
  state.v = make_field(d);
  state.u = make_field(d);
  state.density = make_field(1);
  state.stress = make_field(d * d);
  state.F = make_field(d * d);
  state.gradient = make_field(d * d);
  state.plastic = make_field(static_cast<int>(law_.kept().size()));
  if (options_.dissipation != "none") state.heat = make_field(1);
  state.anchors = make_field(outside_.contact().anchor_components());
  if (touching_ && touching_->rough()) state.slip = make_field(d);
  if (options_.conservative()) return state;
  state.density_rate = make_field(1);
  if (options_.has_bonds()) state.pull = make_field(d);
  if (options_.geometry == "advection") state.frozen = make_field(d + 1);
  return state;
}

template <int d>
UpdatedState<d> Updated<d>::start(const InitialMotion<d>& motion) {
  State state = make_state();
  for (std::size_t i = 0; i < motion.u.size(); ++i)
    set_vector<d>(state.u, static_cast<Index>(i), motion.u[i]);
  for (std::size_t i = 0; i < motion.v.size(); ++i)
    set_vector<d>(state.v, static_cast<Index>(i), motion.v[i]);
  outside_.start(state.u, state.v);
  outside_.contact().start(state.u, state.anchors);
  for (Index i = 0; i < count(); ++i) {
    state.density[0][i] = law_.density;
    store(law_.at_rest(motion.temperature_of(i)), state, i);
    set_tensor<d>(state.F, i, Mat<d>::Identity());
  }
  if (!motion.u.empty()) deform(state, motion);
  load(state);
  neighbours_.update(x_);
  state.bonds.move_to(neighbours_.list());
  for (Index i = 0; i < count(); ++i) V_[i] = mass_[i] / state.density[0][i];
  differentiate(state);
  return state;
}

/// Density and stress of the deformation that corrected sums of the reference give: that of Hencky's law.
template <int d>
void Updated<d>::deform(State& state, const InitialMotion<d>& motion) {
  const Cloud<d>& cloud = specimen_.cloud;
  x_ = cloud.X;
  V_ = cloud.V;
  v_ = motion.u;
  neighbours_.update(x_);
  for_rows(pairs(), Seen::velocities, [&](Index i, const PairRow<d>& row) {
    const Mat<d> F = Mat<d>::Identity() + row.minus_sum(row.v) * row.minus_sum(row.r).inverse();
    Point point = law_.at_rest();
    point.s = law_.deviator_of(F);
    law_.give_back(point, slowly, law_.density / F.determinant());
    store(point, state, i);
    state.density[0][i] = law_.density / F.determinant();
    set_tensor<d>(state.F, i, F);
  });
}

template <int d>
typename RateLaw<d>::Point Updated<d>::point_of(const State& state, Index i) const {
  return law_.recall(tensor_at<d>(state.stress, i), state.plastic, i);
}

template <int d>
void Updated<d>::store(const Point& point, State& state, Index i) const {
  set_tensor<d>(state.stress, i, point.s);
  law_.keep(point, state.plastic, i);
}

template <int d>
std::optional<Trouble> Updated<d>::load(const State& state) {
  for_particles(count(), [&](Index i) {
    x_[i] = specimen_.cloud.X[i] + vector_at<d>(state.u, i);
    v_[i] = vector_at<d>(state.v, i);
  });
  return find_trouble(state);
}

template <int d>
std::optional<Trouble> Updated<d>::find_trouble(const State& state) const {
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
double Updated<d>::wave_speed() const {
  if (options_.speed == "bulk") return law_.sound_speed();
  const LatticeSums sums = lattice_sums<d>(options_.beta);
  const double in_dimension = options_.deviator == "plane-strain" || d == 3 ? 4.0 / 3 : 1;
  const double shear =
      options_.form == "eno" ? std::max(in_dimension, 0.5 * options_.strength(d) * sums.xxxx) : in_dimension;
  return std::sqrt((law_.bulk + shear * law_.shear) / law_.density);
}

template <int d>
double Updated<d>::step_limit(const State& state) const {
  const double by_walls =
      outside_.contact().empty() ? std::numeric_limits<double>::infinity() : outside_.contact().step_limit();
  if (options_.speed != "bulk") return std::min(by_walls, options_.cfl * h_ / wave_speed());
  double square = 0;
  for (Index i = 0; i < count(); ++i) square = std::max(square, vector_at<d>(state.v, i).squaredNorm());
  return std::min(by_walls, options_.cfl * h_ / (wave_speed() + std::sqrt(square)));
}

template <int d>
std::optional<Trouble> Updated<d>::advance(State& state, double dt) {
  if (auto trouble = load(state)) return trouble;
  next_.v = state.v;
  next_.anchors = state.anchors;
  next_.slip = state.slip;
  next_.outside = state.outside;
  outside_.begin_step(dt, next_.v, next_.outside);
  if (outside_.damps()) for_particles(count(), [&](Index i) { v_[i] = vector_at<d>(next_.v, i); });
  auto trouble = options_.conservative() ? advance_conservative(state, dt) : advance_printed(state, dt);
  if (trouble) return trouble;
  std::swap(state, next_);
  return std::nullopt;
}

template <int d>
void Updated<d>::correct() {
  Index blended = 0;
#pragma omp parallel for schedule(static) reduction(+ : blended) if (count() >= particles_for_threads)
  for (Index i = 0; i < count(); ++i) {
    const GuardedCorrection<d> made = correction_of<d>(M_[i], least_det_[i]);
    B_[i] = made.B;
    blended += made.kept < 1;
  }
  guarded_ += blended;
}

template <int d>
void Updated<d>::differentiate(State& state) {
  for_rows(pairs(), Seen::velocities, [&](Index i, const PairRow<d>& row) {
    M_[i] = row.minus_sum(row.r);
    S_[i] = row.minus_sum(row.v);
    near_[i] = static_cast<std::int32_t>(row.count);
  });
  correct();
  counts_ = {};
  for (Index i = 0; i < count(); ++i) {
    counts_.pairs += near_[i];
    counts_.most = std::max<Index>(counts_.most, near_[i]);
    set_tensor<d>(state.gradient, i, S_[i] * B_[i]);
  }
}

template class Updated<1>;
template class Updated<2>;
template class Updated<3>;

}  // namespace plumb
