#include "lib/schemes/tlsph/boundary/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

/// A look costs two evaluations; the motions that take long to settle change little in ten steps.
constexpr long steps_between_looks = 10;
/// Of the displacements whose forces are compared, in spacings: small against strains, large against
/// rounding.
constexpr double probing = 1e-4;

/// Sum of V a . b over all slots.
template <int d>
double product(const Solid<d>& solid, const Field& a, const Field& b) {
  double sum = 0;
  for (int k = 0; k < d; ++k)
    for (Index slot = 0; slot < solid.bonds.slots.count(); ++slot)
      sum += solid.volume[slot] * a[k][slot] * b[k][slot];
  return sum;
}

/// Norm of the forces V f [N].
template <int d>
double norm(const Solid<d>& solid, const Field& f) {
  double sum = 0;
  for (int k = 0; k < d; ++k)
    for (Index slot = 0; slot < solid.bonds.slots.count(); ++slot) {
      const double force = solid.volume[slot] * f[k][slot];
      sum += force * force;
    }
  return std::sqrt(sum);
}

template <int d>
double largest_of(const Solid<d>& solid, const Field& a) {
  double most = 0;
  for (int k = 0; k < d; ++k)
    for (Index slot = 0; slot < solid.bonds.slots.count(); ++slot)
      most = std::max(most, std::abs(a[k][slot]));
  return most;
}

/// a += factor b.
template <int d>
void add(const Solid<d>& solid, double factor, const Field& b, Field& a) {
  for (int k = 0; k < d; ++k)
    for (Index slot = 0; slot < solid.bonds.slots.count(); ++slot) a[k][slot] += factor * b[k][slot];
}

/// Angular frequency of the motion v about this state by Rayleigh's quotient [1/s]; 0 where the forces drive
/// it on.
template <int d>
double frequency(const Solid<d>& solid, const OpenForces<d>& forces, Workspace<d>& workspace, State<d> still,
                 Field open, const Field& v) {
  const double speed = largest_of(solid, v);
  if (speed == 0) return 0;
  const double e = probing * solid.cloud.spacing / speed;
  add(solid, e, v, still.u);
  const auto moved = forces.at(solid, workspace, still);
  if (!moved) return 0;
  add(solid, -1, *moved, open);  // what the move takes off the forces
  const double square = product(solid, open, v) / (e * solid.elastic.density * product(solid, v, v));
  return square > 0 ? std::sqrt(square) : 0;
}

}  // namespace

template <int d>
std::optional<double> Relaxation<d>::damp(const Solid<d>& solid, State<d>& state, double dt) {
  Field moving = state.v;
  forces_->for_each_held([&](int component, Index slot) { moving[component][slot] = 0; });
  add(solid, std::expm1(-rate_ * dt), moving, state.v);  // held components keep their velocity
  if (state.step % steps_between_looks != 0) return std::nullopt;
  return look(solid, state);
}

template <int d>
std::optional<double> Relaxation<d>::look(const Solid<d>& solid, const State<d>& state) {
  State<d> still = state;
  for (int k = 0; k < d; ++k) std::fill_n(still.v[k], solid.bonds.slots.count(), 0.0);
  Workspace<d> workspace;
  auto open = forces_->at(solid, workspace, still);
  if (!open) return std::nullopt;  // the next step will say so
  Field moving = state.v;
  double held = 0;
  forces_->for_each_held([&](int component, Index slot) {
    const double f = solid.volume[slot] * (*open)[component][slot];
    held += f * f;
    (*open)[component][slot] = 0;
    moving[component][slot] = 0;
  });
  const double scale = std::max(std::sqrt(held), norm(solid, forces_->of_loads(solid, workspace, still)));
  rate_ = 2 * frequency(solid, *forces_, workspace, still, *open, moving);
  const double unbalanced = norm(solid, *open);
  if (unbalanced == 0) return 0;
  return scale > 0 ? unbalanced / scale : std::numeric_limits<double>::infinity();
}

template class Relaxation<1>;
template class Relaxation<2>;
template class Relaxation<3>;

}  // namespace plumb
