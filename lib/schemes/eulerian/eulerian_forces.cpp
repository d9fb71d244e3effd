#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/point_fields.hpp"

/// Forces between pairs [N]: THEORY (18.7) to (18.10). r_ij = x_i - x_j, w = W'/r.
namespace plumb {
namespace {

/// The tensile part of a stress: what is left when its negative principal values are set to 0, (19), (20).
template <int d>
Mat<d> tensile(const Mat<d>& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat<d>> principal(0.5 * (stress + stress.transpose()));
  const Vec<d> kept = principal.eigenvalues().cwiseMax(0);
  return principal.eigenvectors() * kept.asDiagonal() * principal.eigenvectors().transpose();
}

/// The largest principal stress, or 0 where none is tensile [Pa].
template <int d>
double largest_tension(const Mat<d>& stress) {
  return std::max(
      0.0, Eigen::SelfAdjointEigenSolver<Mat<d>>(0.5 * (stress + stress.transpose()), Eigen::EigenvaluesOnly)
               .eigenvalues()
               .maxCoeff());
}

}  // namespace

template <int d>
void Eulerian<d>::stress_forces(State& state) {
  const double epsilon = options_.artificial_stress;
  for_particles(count(), [&](Index i) {
    const Mat<d> stress = tensor_at<d>(state.stress, i) - pressure_of(state, i) * Mat<d>::Identity();
    const double rho = state.density[0][i];
    const double sum_of_weights = options_.printed() ? shepard_[i] : 1;
    const Mat<d> normal =
        options_.adjoint() ? L_[i] : Mat<d>(Mat<d>::Identity() / (rho * rho * sum_of_weights));
    S_[i] = (stress + extra_[i]) * normal;
    if (epsilon > 0) repulsion_[i] = epsilon * tensile<d>(stress) * normal;
  });
  const double nearby = kernel_.value(specimen_.cloud.spacing);
  // (11) has masses and densities of now; the adjoint force has the volumes that made L
  const std::vector<double>& weight = options_.adjoint() ? V_ : mass_;
  const MovingPairs<d, SplinePairs<d>> weighed{*neighbours_.list(), kernel_, x_, v_, weight};
  for_rows(weighed, Seen::positions, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = Vec<d>::Zero(), sum = Vec<d>::Zero();
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> wr = row.weight[m] * row.r_of(m);
      sum += wr;
      force += S_[j] * wr;
      if (epsilon > 0) {
        const double f = kernel_.value(row.distance[m]) / nearby;
        force -= std::pow(f, options_.artificial_exponent) * ((repulsion_[i] + repulsion_[j]) * wr);
      }
    }
    set_vector<d>(state.force, i, weight[i] * (force + S_[i] * sum));
  });
}

/// Weighed xi of (32) at a particle, which tension raises: (18.11).
template <int d>
double Eulerian<d>::stiffness_of(const State& state, Index i) const {
  if (options_.xi_tension == 0) return options_.stiffness();
  const Mat<d> stress = tensor_at<d>(state.stress, i) - pressure_of(state, i) * Mat<d>::Identity();
  const double share = largest_tension<d>(stress) / young();
  return options_.stiffness() + options_.stiffness_share() * options_.xi_tension * share * share;
}

/// (32), (33) and (34) with the signs that resist the error, and (33) with a density: of F_i and F_j as they
/// are, and of the places before any deformation; or both since the latest reference.
template <int d>
void Eulerian<d>::hourglass_forces(State& state) {
  const bool stiff = options_.stiffness_share() > 0;
  const double half_modulus = (options_.misprinted("32") ? -0.5 : 0.5) * young();
  if (stiff) for_particles(count(), [&](Index i) { stiff_[i] = half_modulus * stiffness_of(state, i); });
  const bool as_printed = options_.misprinted("33");
  const double viscous = (as_printed ? -1 : 1) * options_.viscous() * law_.sound_speed() * h_;
  const double far = 2 / kernel_.per_reach;  // pairs that were farther apart at first are none of the body
  const auto failed = [&](Index i) { return law_.failed(damage_of(state, i)); };
  const bool incremental = options_.incremental_error;
  for_particles(count(), [&](Index i) {
    S_[i] = 0.5 * (incremental ? reference_->gradient(x_, i) : tensor_at<d>(state.F, i));
  });
  const std::vector<Vec<d>>& places = incremental ? reference_->x() : specimen_.cloud.X;
  for_rows(pairs(), viscous != 0 ? Seen::openings : Seen::positions, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = Vec<d>::Zero();
    for (Index m = 0; m < row.count; ++m) {
      const Index j = row.other[m];
      const Vec<d> X = places[i] - places[j], r = row.r_of(m);
      const double length = X.squaredNorm(), square = row.distance[m] * row.distance[m];
      if (length > far * far || failed(i) || failed(j)) continue;
      const Vec<d> error = (S_[i] + S_[j]) * X - r;  // (31)
      const double along = error.dot(r) / square;
      if (stiff)
        force += ((stiff_[i] + stiff_[j]) * V_[j] * kernel_.value(row.distance[m]) / length * along) * r;
      if (viscous != 0 && row.opening[m] * along < 0) {
        const double density = 0.5 * (state.density[0][i] + state.density[0][j]);
        const double volume = as_printed ? 1 : mass_[i] * mass_[j] / (V_[i] * V_[j] * density);
        force += (viscous * volume * row.weight[m] * std::sqrt(error.squaredNorm() / length) *
                  row.opening[m] / square) *
                 r;
      }
    }
    set_vector<d>(state.hourglass, i, V_[i] * force);
  });
}

/// (17) with (18), as m_i m_j Pi_ij grad W.
template <int d>
void Eulerian<d>::viscous_forces(State& state) {
  const double alpha = options_.viscosity_linear * law_.sound_speed(), beta = options_.viscosity_quadratic;
  for_rows(pairs(), Seen::openings, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = Vec<d>::Zero();
    for (Index m = 0; m < row.count; ++m) {
      if (row.opening[m] >= 0) continue;
      const Index j = row.other[m];
      const double phi = h_ * row.opening[m] / (row.distance[m] * row.distance[m]);
      const double density = 0.5 * (state.density[0][i] + state.density[0][j]);
      force += ((alpha - beta * phi) * phi / density * (mass_[j] / V_[j]) * row.weight[m]) * row.r_of(m);
    }
    set_vector<d>(state.viscous, i, mass_[i] * force);
  });
}

template <int d>
void Eulerian<d>::find_forces(State& state) {
  stress_forces(state);
  if (options_.controls_hourglass()) hourglass_forces(state);
  if (options_.has_viscosity()) viscous_forces(state);
  for_particles(count(), [&](Index i) {
    Vec<d> sum = vector_at<d>(state.force, i);
    for (const Field* force : {&state.hourglass, &state.viscous})
      if (force->components() > 0) sum += vector_at<d>(*force, i);
    set_vector<d>(state.acceleration, i, sum / mass_[i]);
  });
}

/// Also the couples that friction puts on the stress, by the adjoint force: THEORY (19.6).
template <int d>
void Eulerian<d>::press_bodies(State& state, double apart) {
  if (!touching_) return;
  touching_->find(x_, {v_, A_, apart}, state.slip);
  const std::vector<Vec<d>>& forces = touching_->forces();
  const auto* couples = touching_->couples();
  if (couples) for_particles(count(), [&](Index i) { S_[i] = (*couples)[i] / V_[i] * L_[i]; });
  for_rows(pairs(), Seen::positions, [&](Index i, const PairRow<d>& row) {
    Vec<d> force = forces[i];
    if (couples) force += V_[i] * row.adjoint_sum(S_, i);
    set_vector<d>(state.between, i, force / mass_[i]);
  });
}

template <int d>
void Eulerian<d>::add_outside(const State& state, Field& anchors) {
  kick_ = state.acceleration;
  outside_.add_loads(state.time, keeps_F() ? &state.F : nullptr, kick_);
  if (outside_.contact().empty()) return;
  for_particles(count(), [&](Index i) { x_[i] = specimen_.cloud.X[i] + vector_at<d>(state.u, i); });
  outside_.add_contact(state.time, x_, anchors, kick_);
  if (touching_) outside_.add_between(state.between, kick_);
}

template <int d>
std::optional<OpenAcceleration> Eulerian<d>::open(const State& state, bool still) {
  if (find_trouble(state)) return std::nullopt;
  if (still) {
    follow_reference(state);
    for_particles(count(), [&](Index i) {
      x_[i] = specimen_.cloud.X[i] + vector_at<d>(state.u, i);
      v_[i] = Vec<d>::Zero();
      V_[i] = mass_[i] / state.density[0][i];
      extra_[i] = Mat<d>::Zero();
    });
    const long singular = singular_;  // counted when the step was made
    sum_up();
    singular_ = singular;
    next_ = state;
    find_forces(next_);
    press_bodies(next_, 0);
  }
  next_.anchors = state.anchors;
  add_outside(still ? next_ : state, next_.anchors);
  return OpenAcceleration{kick_, outside_.loads()};
}

#define PLUMBLINE_INSTANTIATE(d)                                                   \
  template void Eulerian<d>::stress_forces(EulerianState<d>&);                     \
  template double Eulerian<d>::stiffness_of(const EulerianState<d>&, Index) const; \
  template void Eulerian<d>::hourglass_forces(EulerianState<d>&);                  \
  template void Eulerian<d>::viscous_forces(EulerianState<d>&);                    \
  template void Eulerian<d>::find_forces(EulerianState<d>&);                       \
  template void Eulerian<d>::press_bodies(EulerianState<d>&, double);              \
  template void Eulerian<d>::add_outside(const EulerianState<d>&, Field&);         \
  template std::optional<OpenAcceleration> Eulerian<d>::open(const EulerianState<d>&, bool);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
