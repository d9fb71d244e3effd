#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Geometry>  // cross
#include <algorithm>
#include <functional>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/core/in_space.hpp"
#include "lib/geometry/cloud.hpp"

/// The projection of forces onto those without torque. THEORY (5.4), (5.6)
namespace plumb {

/// Holds sums with volumes over all particles; in 2D torque and turning are about z alone.
struct TorqueSums {
  double volume = 0;
  Vec<3> arm = Vec<3>::Zero(), force = Vec<3>::Zero(), torque = Vec<3>::Zero();
  Mat<3> inertia = Mat<3>::Zero();
  TorqueSums& operator+=(const TorqueSums& other) {
    volume += other.volume;
    arm += other.arm;
    force += other.force;
    torque += other.torque;
    inertia += other.inertia;
    return *this;
  }
};

/// Particles that one thread adds up; bodies below have one.
inline constexpr Index torque_part = 4096;

/// Adds up parts of a fixed size in order: the same bits for any number of threads.
template <class Add>
TorqueSums torque_sums_over(Index particles, Add&& add) {
  std::vector<TorqueSums> parts((particles + torque_part - 1) / torque_part);
#pragma omp parallel for schedule(static) if (particles > torque_part)
  for (Index part = 0; part < static_cast<Index>(parts.size()); ++part)
    for (Index i = part * torque_part; i < std::min(particles, (part + 1) * torque_part); ++i)
      add(parts[part], i);
  TorqueSums sum;
  for (const TorqueSums& part : parts) sum += part;
  return sum;
}

/// Solves (inertia) w = -torque; in 2D about z.
template <int d>
Vec<3> torque_turning(const TorqueSums& about_centre) {
  if constexpr (d == 2) return Vec<3>(0, 0, -about_centre.torque[2] / about_centre.inertia(2, 2));
  return about_centre.inertia.ldlt().solve(-about_centre.torque);
}

/// Changes forces per reference volume [N/m^d], by slot, by the least that leaves them without resultant
/// and without torque about X + arm(slot) (paper 003, (64)-(67); THEORY (5.4), (5.6)). `x`: room of one vector per particle. In 2D and 3D.
template <int d>
void take_torque_off(const Cloud<d>& cloud, const Slots& slots, const std::function<Vec<d>(Index)>& arm,
                     std::vector<Vec<3>>& x, Field& force) {
  const Index n = cloud.size();
#pragma omp parallel for schedule(static) if (n > torque_part)
  for (Index i = 0; i < n; ++i) x[i] = in_space<d>(cloud.X[i] + arm(slots.of(i)));
  const TorqueSums means = torque_sums_over(n, [&](TorqueSums& sum, Index i) {
    sum.volume += cloud.V[i];
    sum.arm += cloud.V[i] * x[i];
    sum.force += cloud.V[i] * in_space<d>(vector_at<d>(force, slots.of(i)));
  });
  const Vec<3> centre = means.arm / means.volume, mean_force = means.force / means.volume;
  const TorqueSums turn = torque_sums_over(n, [&](TorqueSums& sum, Index i) {
    x[i] -= centre;
    const double V = cloud.V[i];
    sum.torque += V * x[i].cross(in_space<d>(vector_at<d>(force, slots.of(i))));
    sum.inertia += V * (x[i].squaredNorm() * Mat<3>::Identity() - x[i] * x[i].transpose());
  });
  const Vec<3> w = torque_turning<d>(turn);
#pragma omp parallel for schedule(static) if (n > torque_part)
  for (Index i = 0; i < n; ++i) {
    const Vec<3> change = w.cross(x[i]) - mean_force;
    for (int k = 0; k < d; ++k) force[k][slots.of(i)] += change[k];
  }
}

}  // namespace plumb
