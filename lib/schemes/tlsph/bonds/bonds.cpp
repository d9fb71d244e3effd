#include <fmt/format.h>

#include "lib/geometry/position_text.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {
namespace {

/// Weights w_ij of the corrected Laplacian: phi_j = -factor W'(r)/r less its linear part. THEORY (6.2).
template <int d>
void add_laplacian(std::vector<BondConstants<d>>& bonds, const std::vector<double>& volume,
                   const BondOptions<d>& options) {
  const double h = options.smoothing_length;
  Vec<d> linear = Vec<d>::Zero();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const double r = bonds[b].separation.norm();
    bonds[b].laplacian = -options.laplacian_factor * options.kernel.dw(r / h) / (std::pow(h, d + 1) * r);
    linear += volume[b] * bonds[b].laplacian * bonds[b].separation;
  }
  for (std::size_t b = 0; b < bonds.size(); ++b)
    bonds[b].laplacian -= linear.dot(bonds[b].gradient) / volume[b];
}

}  // namespace

template <int d>
std::vector<BondConstants<d>> bonds_of(const Cloud<d>& cloud, std::span<const std::int32_t> neighbours,
                                       Index i, const BondOptions<d>& options) {
  std::vector<Neighbour<d>> seen;
  seen.reserve(neighbours.size());
  for (const auto j : neighbours) seen.push_back({cloud.X[j] - cloud.X[i], cloud.V[j]});
  CorrectedKernel<d> kernel;
  try {
    kernel = correct<d>(options.pair, options.kernel, options.smoothing_length, seen);
  } catch (const InputError& e) {
    throw InputError(
        fmt::format("particle {} at {} m has a {}", i, position_text<d>(cloud.X[i]), e.problem()), e.why(),
        e.suggestion());
  }
  const std::vector<Vec<d>> stencil = options.estimator(seen, kernel);
  std::vector<BondConstants<d>> bonds;
  std::vector<double> volume;
  for (std::size_t n = 0; n < seen.size(); ++n) {
    if (neighbours[n] == i) continue;
    bonds.push_back({neighbours[n], seen[n].separation, stencil[n], kernel.gradient[n], 0.0});
    volume.push_back(seen[n].volume);
  }
  if (options.laplacian) add_laplacian<d>(bonds, volume, options);
  return bonds;
}

template std::vector<BondConstants<1>> bonds_of<1>(const Cloud<1>&, std::span<const std::int32_t>, Index,
                                                   const BondOptions<1>&);
template std::vector<BondConstants<2>> bonds_of<2>(const Cloud<2>&, std::span<const std::int32_t>, Index,
                                                   const BondOptions<2>&);
template std::vector<BondConstants<3>> bonds_of<3>(const Cloud<3>&, std::span<const std::int32_t>, Index,
                                                   const BondOptions<3>&);

}  // namespace plumb
