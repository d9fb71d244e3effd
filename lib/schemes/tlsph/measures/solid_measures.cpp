#include "lib/schemes/tlsph/measures/solid_measures.hpp"

#include <limits>

#include "lib/measures/over_particles.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"

namespace plumb {

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
  Energy energy{0.5 * solid.elastic.density * twice_kinetic, strain, {}, {}};
  for (const auto& term : solid.terms)
    if (term.energy) energy.more.push_back({term.name, term.energy(solid, state)});
  if (const auto& history = solid.sweeps.history) {
    const double* density = history->field[history->plastic_work().first];
    double work = 0;
    for (Index slot = 0; slot < solid.bonds.slots.count(); ++slot) work += solid.volume[slot] * density[slot];
    energy.more.push_back({history->plastic_work().name, work});
  }
  return energy;
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
Extent<d> extent_of(const Solid<d>& solid, const State<d>& state) {
  return extent_over<d>(solid.cloud.size(), [&](Index i) { return position_of(solid, state, i); });
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

template Energy energy_of<1>(const Solid<1>&, const State<1>&);
template Energy energy_of<2>(const Solid<2>&, const State<2>&);
template Energy energy_of<3>(const Solid<3>&, const State<3>&);
template double energy_round_off<1>(const Solid<1>&);
template double energy_round_off<2>(const Solid<2>&);
template double energy_round_off<3>(const Solid<3>&);
template Momentum momentum_of<1>(const Solid<1>&, const State<1>&);
template Momentum momentum_of<2>(const Solid<2>&, const State<2>&);
template Momentum momentum_of<3>(const Solid<3>&, const State<3>&);
template Extent<1> extent_of<1>(const Solid<1>&, const State<1>&);
template Extent<2> extent_of<2>(const Solid<2>&, const State<2>&);
template Extent<3> extent_of<3>(const Solid<3>&, const State<3>&);
template double hourglass_share<1>(const Solid<1>&, const State<1>&);
template double hourglass_share<2>(const Solid<2>&, const State<2>&);
template double hourglass_share<3>(const Solid<3>&, const State<3>&);

}  // namespace plumb
