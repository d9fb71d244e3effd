#include "lib/schemes/tlsph/bonds/own_supports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/core/error.hpp"
#include "lib/geometry/neighbours.hpp"
#include "lib/geometry/position_text.hpp"

namespace plumb {
namespace {

/// c_ij of one particle whose support has that radius; false if its neighbours do not span the space.
template <int d>
bool set_vectors(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double radius,
                 std::vector<BondConstants<d>>& bonds) {
  const double h = radius / kernel.support;
  std::vector<Neighbour<d>> inside;
  Mat<d> L = Mat<d>::Zero();  // without the sign of W', and in units of h
  for (BondConstants<d>& bond : bonds) {
    const double r = bond.separation.norm();
    const bool counts = r < radius && kernel.dw(r / h) != 0;
    bond.stencil = counts ? Vec<d>(-cloud.V[bond.other] * kernel.dw(r / h) / r * bond.separation)
                          : Vec<d>(Vec<d>::Zero());
    L += bond.stencil * bond.separation.transpose();
    if (counts) inside.push_back({bond.separation, cloud.V[bond.other]});
  }
  if (independent_directions<d>(inside) < d) return false;
  const Mat<d> inverse = L.inverse();
  for (BondConstants<d>& bond : bonds) bond.stencil = inverse * bond.stencil;
  return true;
}

}  // namespace

template <int d>
std::vector<double> support_radii(const Cloud<d>& cloud, long k) {
  if (cloud.size() <= k)
    throw InputError(fmt::format("{} particles have no {} neighbours each", cloud.size(), k), "",
                     "ask for fewer, or use a smaller spacing");
  const NeighbourSearch<d> search(cloud.X);
  std::vector<double> radii(cloud.X.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < cloud.size(); ++i) {
    std::vector<Index> found;
    double reach = cloud.spacing;
    do search.within(cloud.X[i], reach *= 1.5, found);
    while (static_cast<long>(found.size()) <= k);
    std::vector<double> distance;
    for (const Index j : found) distance.push_back((cloud.X[j] - cloud.X[i]).norm());
    std::nth_element(distance.begin(), distance.begin() + k, distance.end());  // the first is its own, 0
    radii[i] = distance[k];
  }
  return radii;
}

template <int d>
std::vector<Vec<d>> normalised_kernel_gradient(Neighbourhood<d> neighbours,
                                               const CorrectedKernel<d>& kernel) {
  if (independent_directions<d>(neighbours) < d)
    throw InputError(fmt::format("neighbourhood with fewer than {} independent directions", d),
                     "the gradient of the kernel cannot be normalised there", "use a larger beta");
  std::vector<Vec<d>> c = kernel.gradient;
  normalise_gradient<d>(neighbours, c);
  return c;
}

template <int d>
void use_own_supports(BondOptions<d>& options, std::vector<double> radius) {
  options.smoothing_length = *std::max_element(radius.begin(), radius.end()) / options.kernel.support;
  options.project = [kernel = options.kernel, radius = std::move(radius)](Cloud<d>& cloud, const Neighbours&,
                                                                          auto& bonds) {
    for (std::size_t i = 0; i < bonds.size(); ++i)
      if (!set_vectors<d>(cloud, kernel, radius[i], bonds[i]))
        throw InputError(
            fmt::format(
                "particle {} at {} m has a support of {:g} m with fewer than {} independent directions", i,
                position_text<d>(cloud.X[i]), radius[i], d),
            "the farthest neighbours of a support have no weight", "ask for more neighbours");
  };
}

#define PLUMBLINE_INSTANTIATE(d)                                                                           \
  template std::vector<double> support_radii<d>(const Cloud<d>&, long);                                    \
  template std::vector<Vec<d>> normalised_kernel_gradient<d>(Neighbourhood<d>, const CorrectedKernel<d>&); \
  template void use_own_supports<d>(BondOptions<d>&, std::vector<double>);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
