#pragma once
#include <vector>

#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {

/// One undirected pair i < j in units of the spacing: A_ij = -A_ji is the area through which the two
/// particles see each other. Also the places of the bond in the lists of i and of j.
template <int d>
struct AreaVector {
  std::int32_t i, j;
  std::int32_t place_i, place_j;
  Vec<d> X;       ///< X_ij
  Vec<d> A;       ///< A_ij
  double weight;  ///< how readily A_ij is changed: W(r_ij)/W(0)
};

/// The unknowns of the projection, in units of the spacing: area vectors and volumes.
template <int d>
struct AreaTable {
  std::vector<AreaVector<d>> pairs;
  std::vector<double> volume;
  std::vector<Vec<d>> boundary;  ///< B_i, outward; given
  double spacing;                ///< [m]

  Index particles() const { return static_cast<Index>(volume.size()); }
};

/// The skew part of a start table, A0_ij = V_i c_ij - V_j c_ji. THEORY (11.3).
template <int d>
AreaTable<d> area_table(const Cloud<d>& cloud, const std::vector<std::vector<BondConstants<d>>>& bonds,
                        const RadialKernel<d>& kernel, double h, const std::vector<Vec<d>>& boundary);

/// Writes c_ij = A_ij/(2 V_i) into stencil and gradient of both directions, and the volumes into the cloud.
/// THEORY (11.4).
template <int d>
void write_back(const AreaTable<d>& table, Cloud<d>& cloud,
                std::vector<std::vector<BondConstants<d>>>& bonds);

}  // namespace plumb
