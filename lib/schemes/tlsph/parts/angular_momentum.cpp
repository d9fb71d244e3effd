#include "lib/schemes/tlsph/parts/angular_momentum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>  // cross

#include "lib/core/in_space.hpp"

namespace plumb {
namespace {

/// Sums with volumes over all particles; in 2D torque and turning are about z alone.
struct Sums {
  double volume = 0;
  Vec<3> arm = Vec<3>::Zero(), force = Vec<3>::Zero(), torque = Vec<3>::Zero();
  Mat<3> inertia = Mat<3>::Zero();
  Sums& operator+=(const Sums& other) {
    volume += other.volume;
    arm += other.arm;
    force += other.force;
    torque += other.torque;
    inertia += other.inertia;
    return *this;
  }
};

/// Particles that one thread adds up; bodies below have one.
constexpr Index part_size = 4096;

/// The same bits for any number of threads: parts of a fixed size, added in order.
template <class Add>
Sums sum_over(Index particles, Add&& add) {
  std::vector<Sums> parts((particles + part_size - 1) / part_size);
#pragma omp parallel for schedule(static) if (particles > part_size)
  for (Index part = 0; part < static_cast<Index>(parts.size()); ++part)
    for (Index i = part * part_size; i < std::min(particles, (part + 1) * part_size); ++i)
      add(parts[part], i);
  Sums sum;
  for (const Sums& part : parts) sum += part;
  return sum;
}

/// w with (inertia) w = -torque; in 2D about z.
template <int d>
Vec<3> turning(const Sums& about_centre) {
  if constexpr (d == 2) return Vec<3>(0, 0, -about_centre.torque[2] / about_centre.inertia(2, 2));
  return about_centre.inertia.ldlt().solve(-about_centre.torque);
}

}  // namespace

template <int d>
void take_torque_off(const Cloud<d>& cloud, const Slots& slots, const Arm<d>& arm, std::vector<Vec<3>>& x,
                     Field& force) {
  const Index n = cloud.size();
#pragma omp parallel for schedule(static) if (n > part_size)
  for (Index i = 0; i < n; ++i) x[i] = in_space<d>(cloud.X[i] + arm(slots.of(i)));
  const Sums means = sum_over(n, [&](Sums& sum, Index i) {
    sum.volume += cloud.V[i];
    sum.arm += cloud.V[i] * x[i];
    sum.force += cloud.V[i] * in_space<d>(vector_at<d>(force, slots.of(i)));
  });
  const Vec<3> centre = means.arm / means.volume, mean_force = means.force / means.volume;
  const Sums turn = sum_over(n, [&](Sums& sum, Index i) {
    x[i] -= centre;
    const double V = cloud.V[i];
    sum.torque += V * x[i].cross(in_space<d>(vector_at<d>(force, slots.of(i))));
    sum.inertia += V * (x[i].squaredNorm() * Mat<3>::Identity() - x[i] * x[i].transpose());
  });
  const Vec<3> w = turning<d>(turn);
#pragma omp parallel for schedule(static) if (n > part_size)
  for (Index i = 0; i < n; ++i) {
    const Vec<3> change = w.cross(x[i]) - mean_force;
    for (int k = 0; k < d; ++k) force[k][slots.of(i)] += change[k];
  }
}

template <int d>
Term<d> angular_momentum_projection(const Solid<d>& solid) {
  const auto arms = std::make_shared<std::vector<Vec<3>>>(solid.cloud.size());  // then from their centre
  Term<d> term;
  term.name = "projection";
  term.bytes = arms->size() * sizeof(Vec<3>);
  // four passes: X and u read, x written; V, x, f read; V, f read, x changed; x read, f changed
  term.bytes_per_update = sizeof(double) * (5.0 * 3 + 2 + 6.0 * d);
  term.whole = [arms](const Solid<d>& body, const Instant<d>& now, const Arm<d>& arm, Field& force) {
    const Arm<d> at = arm ? arm : [&now](Index slot) { return vector_at<d>(now.state.u, slot); };
    take_torque_off(body.cloud, body.bonds.slots, at, *arms, force);
  };
  return term;
}

template void take_torque_off<2>(const Cloud<2>&, const Slots&, const Arm<2>&, std::vector<Vec<3>>&, Field&);
template void take_torque_off<3>(const Cloud<3>&, const Slots&, const Arm<3>&, std::vector<Vec<3>>&, Field&);
template Term<2> angular_momentum_projection<2>(const Solid<2>&);
template Term<3> angular_momentum_projection<3>(const Solid<3>&);

}  // namespace plumb
