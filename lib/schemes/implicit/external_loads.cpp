#include "lib/schemes/implicit/external_loads.hpp"

#include <algorithm>

namespace plumb {
namespace {

/// The time at which a load is asked, and what its value there is multiplied by.
struct Asked {
  double time, factor;
  Asked(bool steady, const PathPoint& at) : time(steady ? 0 : at.time), factor(steady ? at.growth : 1) {}
};

template <int d>
Mat<d> gradient_of(const Eigen::VectorXd& gradients, Index particle) {
  Mat<d> F;
  for (int n = 0; n < d * d; ++n) F(n / d, n % d) = gradients[d * d * particle + n];
  return F;
}

}  // namespace

template <int d>
Eigen::VectorXd ExternalLoads<d>::dead(const PathPoint& at) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(d * cloud_.size());
  for (const SurfaceLoad<d>& load : actions_.surface) {
    if (!load.traction) continue;
    const Asked asked(load.steady, at);
    for (const LoadedPlace<d>& place : load.places) {
      force.segment<d>(d * place.particle) +=
          asked.factor * place.size() * load.traction(place.at, place.normal(), asked.time);
    }
  }
  for (const BodyForce<d>& load : actions_.body_forces) {
    const Asked asked(load.steady, at);
    for (Index i = 0; i < cloud_.size(); ++i)
      force.segment<d>(d * i) += asked.factor * cloud_.V[i] * load.per_volume(cloud_.X[i], asked.time);
  }
  return force;
}

template <int d>
bool ExternalLoads<d>::follow() const {
  return std::any_of(actions_.surface.begin(), actions_.surface.end(),
                     [](const SurfaceLoad<d>& load) { return static_cast<bool>(load.pressure); });
}

/// Calls use(particle, -p A N) for every piece of the surface under pressure.
template <int d>
template <class Use>
void ExternalLoads<d>::for_each_pressure(const PathPoint& at, Use&& use) const {
  for (const SurfaceLoad<d>& load : actions_.surface) {
    if (!load.pressure) continue;
    const Asked asked(load.steady, at);
    for (const LoadedPlace<d>& place : load.places)
      use(place.particle,
          Vec<d>(-asked.factor * load.pressure(place.at, asked.time) * place.share * place.area));
  }
}

template <int d>
Eigen::VectorXd ExternalLoads<d>::following(const PathPoint& at, const Eigen::VectorXd& gradients) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(d * cloud_.size());
  for_each_pressure(at, [&](Index i, const Vec<d>& push) {
    force.segment<d>(d * i) += cofactor<d, double>(gradient_of<d>(gradients, i)) * push;
  });
  return force;
}

template <int d>
SparseMatrix ExternalLoads<d>::following_tangent(const PathPoint& at,
                                                 const Eigen::VectorXd& gradients) const {
  std::vector<Eigen::Triplet<double>> entries;
  for_each_pressure(at, [&](Index i, const Vec<d>& push) {
    const Mat<d> F = gradient_of<d>(gradients, i);
    for (int n = 0; n < d * d; ++n) {
      Mat<d> unit = Mat<d>::Zero();
      unit(n / d, n % d) = 1;
      // the cofactor is linear (2D) or quadratic (3D) in F: a central difference of any width is exact
      const Vec<d> change = 0.5 * (cofactor<d, double>(F + unit) - cofactor<d, double>(F - unit)) * push;
      for (int a = 0; a < d; ++a) entries.emplace_back(d * i + a, d * d * i + n, change[a]);
    }
  });
  SparseMatrix tangent(d * cloud_.size(), d * d * cloud_.size());
  tangent.setFromTriplets(entries.begin(), entries.end());
  return tangent;
}

template class ExternalLoads<1>;
template class ExternalLoads<2>;
template class ExternalLoads<3>;

}  // namespace plumb
