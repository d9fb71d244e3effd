#pragma once
#include <algorithm>
#include <vector>

#include "lib/core/in_space.hpp"
#include "lib/measures/measures.hpp"

/// Sums over particles, whatever holds them: in a fixed order, so that they are the same for any number of threads.
namespace plumb {

/// Sums in blocks of particles, in a fixed order.
template <class T, class F>
T sum_over_particles(Index n, T zero, F&& add) {
  const Index per_part = 4096;
  std::vector<T> parts((n + per_part - 1) / per_part, zero);
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < static_cast<Index>(parts.size()); ++p)
    for (Index i = p * per_part; i < std::min(n, (p + 1) * per_part); ++i) add(parts[p], i);
  T sum = zero;
  for (const T& part : parts) sum += part;
  return sum;
}

/// Shows what a particle adds to momenta: its mass [kg], position [m] and velocity [m/s].
template <int d>
struct MovingMass {
  double mass;
  Vec<d> x, v;
};

/// Sums up the momenta of particles, of which at(i) gives a MovingMass.
template <int d, class At>
Momentum momentum_over(Index particles, At&& at) {
  using Sums = Eigen::Matrix<double, 8, 1>;
  const Sums sums = sum_over_particles(particles, Sums(Sums::Zero()), [&](Sums& sum, Index i) {
    const MovingMass<d> particle = at(i);
    const Vec<3> v = in_space<d>(particle.v);
    const Vec<3> x = in_space<d>(particle.x);
    const double m = particle.mass;
    Vec<3> L(x[1] * v[2] - x[2] * v[1], x[2] * v[0] - x[0] * v[2], x[0] * v[1] - x[1] * v[0]);
    sum.head<3>() += m * v;
    sum.segment<3>(3) += m * L;
    sum[6] += m * v.norm();
    sum[7] += m * x.norm() * v.norm();
  });
  Momentum p;
  for (int k = 0; k < 3; ++k) p.linear[k] = sums[k], p.angular[k] = sums[3 + k];
  p.linear_scale = sums[6];
  p.angular_scale = sums[7];
  return p;
}

/// Returns the smallest box around points [m]; at(i) gives them.
template <int d, class At>
Extent<d> extent_over(Index particles, At&& at) {
  Extent<d> e{at(0), at(0)};
  for (Index i = 1; i < particles; ++i) {
    const Vec<d> x = at(i);
    e.lower = e.lower.cwiseMin(x);
    e.upper = e.upper.cwiseMax(x);
  }
  return e;
}

}  // namespace plumb
