#include "lib/measures/measures.hpp"

#include <limits>

#include "lib/core/in_space.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"

namespace plumb {
namespace {

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

template <int d>
struct MovingMass {
  double mass;
  Vec<d> x, v;
};

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

}  // namespace

template <int d>
Energy energy_of(const Solid<d>& solid, const State<d>& state) {
  const double twice_kinetic = sum_over_blocks(solid, [&](const Block& block) {
    double sum = 0;
    for (Index i = block.begin(); i < block.end(); ++i)
      sum += solid.volume[i] * vector_at<d>(state.v, i).squaredNorm();
    return sum;
  });
  const double strain = sum_over_blocks(solid, [&](const Block& block) {
    return solid.sweeps.energy(solid.bonds, state.u, block, solid.volume.data());
  });
  double terms = 0;
  for (const auto& term : solid.terms)
    if (term.energy) terms += term.energy(solid, state);
  return {0.5 * solid.elastic.density * twice_kinetic, strain, terms};
}

template <int d>
double energy_round_off(const Solid<d>& solid) {
  constexpr double roundings = 24;  // of J and J^-2/3 (two units by itself), of F:F, of their product
  constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();
  double volume = 0;
  for (const double V : solid.cloud.V) volume += V;
  return roundings * unit * 1.5 * solid.elastic.shear_modulus() * volume;
}

template <int d>
Momentum momentum_of(const Solid<d>& solid, const State<d>& state) {
  return momentum_over<d>(solid.cloud.size(), [&](Index i) {
    return MovingMass<d>{solid.elastic.density * solid.cloud.V[i], position_of(solid, state, i),
                         vector_at<d>(state.v, solid.bonds.slots.of(i))};
  });
}

template <int d>
Momentum momentum_of(const Snapshot<d>& s) {
  return momentum_over<d>(static_cast<Index>(s.x.size()), [&](Index i) {
    return MovingMass<d>{s.mass[i], s.x[i], s.v[i]};
  });
}

template <int d>
Extent<d> extent_of(const Solid<d>& solid, const State<d>& state) {
  return extent_over<d>(solid.cloud.size(), [&](Index i) { return position_of(solid, state, i); });
}

template <int d>
Extent<d> extent_of(const Snapshot<d>& s) {
  return extent_over<d>(static_cast<Index>(s.x.size()), [&](Index i) { return s.x[i]; });
}

template <int d>
double hourglass_share(const Solid<d>& solid, const State<d>& state) {
  const BondTable<d>& t = solid.bonds;
  std::vector<Mat<d>> F(t.slots.count(), Mat<d>::Identity());
  for (Index p = 0; p < solid.cloud.size(); ++p) F[t.slots.of(p)] = deformation_gradient_of(solid, state, p);
  using Sums = Eigen::Vector2d;
  const Sums sums = sum_over_particles(solid.cloud.size(), Sums(Sums::Zero()), [&](Sums& sum, Index p) {
    const Index i = t.slots.of(p);
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      if (X.norm() > 1.1 * solid.cloud.spacing) return;
      const Index j = bond.other;
      const Vec<d> x = X + vector_at<d>(state.u, j) - vector_at<d>(state.u, i);
      sum[0] += (x - 0.5 * (F[i] + F[j]) * X).squaredNorm();
      sum[1] += x.squaredNorm();
    });
  });
  return sums[1] > 0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

template Energy energy_of<2>(const Solid<2>&, const State<2>&);
template Energy energy_of<3>(const Solid<3>&, const State<3>&);
template double energy_round_off<2>(const Solid<2>&);
template double energy_round_off<3>(const Solid<3>&);
template Momentum momentum_of<2>(const Solid<2>&, const State<2>&);
template Momentum momentum_of<3>(const Solid<3>&, const State<3>&);
template Momentum momentum_of<1>(const Snapshot<1>&);
template Momentum momentum_of<2>(const Snapshot<2>&);
template Momentum momentum_of<3>(const Snapshot<3>&);
template Extent<1> extent_of<1>(const Snapshot<1>&);
template Extent<2> extent_of<2>(const Snapshot<2>&);
template Extent<3> extent_of<3>(const Snapshot<3>&);
template Extent<2> extent_of<2>(const Solid<2>&, const State<2>&);
template Extent<3> extent_of<3>(const Solid<3>&, const State<3>&);
template double hourglass_share<2>(const Solid<2>&, const State<2>&);
template double hourglass_share<3>(const Solid<3>&, const State<3>&);

}  // namespace plumb
