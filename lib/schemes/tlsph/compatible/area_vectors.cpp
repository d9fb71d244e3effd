#include "lib/schemes/tlsph/compatible/area_vectors.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {

template <int d>
AreaTable<d> area_table(const Cloud<d>& cloud, const std::vector<std::vector<BondConstants<d>>>& bonds,
                        const RadialKernel<d>& kernel, double h, const std::vector<Vec<d>>& boundary) {
  const double unit = cloud.spacing, volume = std::pow(unit, d), area = std::pow(unit, d - 1);
  AreaTable<d> table;
  table.spacing = unit;
  for (Index i = 0; i < cloud.size(); ++i) {
    table.volume.push_back(cloud.V[i] / volume);
    table.boundary.push_back(boundary[i] / area);
    for (std::size_t n = 0; n < bonds[i].size(); ++n) {
      const BondConstants<d>& ij = bonds[i][n];
      if (ij.other < i) continue;
      const auto& back = bonds[ij.other];  // ascending in `other`
      const auto at = std::lower_bound(back.begin(), back.end(), i,
                                       [](const BondConstants<d>& b, Index k) { return b.other < k; });
      table.pairs.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(ij.other),
                             static_cast<std::int32_t>(n), static_cast<std::int32_t>(at - back.begin()),
                             ij.separation / unit,
                             (cloud.V[i] * ij.stencil - cloud.V[ij.other] * at->stencil) / area,
                             kernel.w(ij.separation.norm() / h) / kernel.w(0)});
    }
  }
  return table;
}

template <int d>
void write_back(const AreaTable<d>& table, Cloud<d>& cloud,
                std::vector<std::vector<BondConstants<d>>>& bonds) {
  for (Index i = 0; i < cloud.size(); ++i) cloud.V[i] = table.volume[i] * std::pow(table.spacing, d);
  for (const auto& pair : table.pairs) {
    BondConstants<d>& ij = bonds[pair.i][pair.place_i];
    BondConstants<d>& ji = bonds[pair.j][pair.place_j];
    ij.stencil = ij.gradient = pair.A / (2 * table.volume[pair.i] * table.spacing);
    ji.stencil = ji.gradient = -pair.A / (2 * table.volume[pair.j] * table.spacing);
  }
}

template AreaTable<1> area_table<1>(const Cloud<1>&, const std::vector<std::vector<BondConstants<1>>>&,
                                    const RadialKernel<1>&, double, const std::vector<Vec<1>>&);
template AreaTable<2> area_table<2>(const Cloud<2>&, const std::vector<std::vector<BondConstants<2>>>&,
                                    const RadialKernel<2>&, double, const std::vector<Vec<2>>&);
template AreaTable<3> area_table<3>(const Cloud<3>&, const std::vector<std::vector<BondConstants<3>>>&,
                                    const RadialKernel<3>&, double, const std::vector<Vec<3>>&);
template void write_back<1>(const AreaTable<1>&, Cloud<1>&, std::vector<std::vector<BondConstants<1>>>&);
template void write_back<2>(const AreaTable<2>&, Cloud<2>&, std::vector<std::vector<BondConstants<2>>>&);
template void write_back<3>(const AreaTable<3>&, Cloud<3>&, std::vector<std::vector<BondConstants<3>>>&);

}  // namespace plumb
