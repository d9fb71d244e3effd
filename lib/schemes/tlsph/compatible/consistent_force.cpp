#include "lib/schemes/tlsph/compatible/consistent_force.hpp"

#include <fmt/format.h>

#include <memory>

namespace plumb {

template <int d>
void make_force_consistent(BondOptions<d>& options, const Cloud<d>& cloud, const Surface<d>& surface) {
  const BoundaryVectors<d> boundary =
      boundary_vectors<d>(cloud, options.kernel, options.smoothing_length, surface);
  if (!(boundary.remainder < 1e-12))  // round-off of moments of order 1
    throw InputError(fmt::format("the surface violates the divergence theorem by {:.3g} of the volume",
                                 boundary.remainder),
                     "too few particles lie on it to correct that", "use a smaller spacing");
  const auto B = std::make_shared<const std::vector<Vec<d>>>(boundary.B);
  options.adjust_force = [B, kernel = options.kernel, h = options.smoothing_length](
                             const Cloud<d>& body, Index i, std::span<const Index> others,
                             std::span<Vec<d>> force, Vec<d>& own) {
    Vec<d> missing = -(*B)[i] / body.V[i] - own;  // (13.1)
    double reach = body.V[i] * kernel.w(0);
    for (std::size_t n = 0; n < others.size(); ++n) {
      missing -= force[n];
      reach += body.V[others[n]] * kernel.w((body.X[others[n]] - body.X[i]).norm() / h);
    }
    const Vec<d> share = missing / reach;  // (13.2)
    own += body.V[i] * kernel.w(0) * share;
    for (std::size_t n = 0; n < others.size(); ++n)
      force[n] += body.V[others[n]] * kernel.w((body.X[others[n]] - body.X[i]).norm() / h) * share;
  };
}

template void make_force_consistent<1>(BondOptions<1>&, const Cloud<1>&, const Surface<1>&);
template void make_force_consistent<2>(BondOptions<2>&, const Cloud<2>&, const Surface<2>&);
template void make_force_consistent<3>(BondOptions<3>&, const Cloud<3>&, const Surface<3>&);

}  // namespace plumb
