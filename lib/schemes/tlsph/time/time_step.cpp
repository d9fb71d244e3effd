#include "lib/schemes/tlsph/time/time_step.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/time/closest_pairs.hpp"

namespace plumb {
namespace {

/// Least principal stretch of every slot.
template <int d>
std::vector<double> least_stretches(const Solid<d>& solid, const State<d>& state) {
  std::vector<double> stretch(solid.bonds.slots.count(), 1.0);
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Mat<d> F = deformation_gradient_of(solid, state, p);
    const Eigen::SelfAdjointEigenSolver<Mat<d>> eigen(F.transpose() * F, Eigen::EigenvaluesOnly);
    stretch[solid.bonds.slots.of(p)] = std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
  }
  return stretch;
}

}  // namespace

template <int d>
double crossing_time(const Solid<d>& solid, const State<d>& state, WaveSpeed speed) {
  const double c = solid.elastic.wave_speed();
  if (speed == WaveSpeed::linear) return least_distance(solid, state) / c;
  double least = std::numeric_limits<double>::max();
  const std::vector<double> stretch = least_stretches(solid, state);
  const BondTable<d>& t = solid.bonds;
#pragma omp parallel for schedule(static) reduction(min : least)
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      const Vec<d> x = X + (vector_at<d>(state.u, bond.other) - vector_at<d>(state.u, i));
      const double mean = 0.5 * (stretch[i] + stretch[bond.other]);
      least = std::min(least, x.norm() / (speed == WaveSpeed::stretch ? c * mean : c / mean));
    });
  }
  return least;
}

template double crossing_time<1>(const Solid<1>&, const State<1>&, WaveSpeed);
template double crossing_time<2>(const Solid<2>&, const State<2>&, WaveSpeed);
template double crossing_time<3>(const Solid<3>&, const State<3>&, WaveSpeed);

}  // namespace plumb
