#pragma once
#include <algorithm>
#include <limits>

#include "lib/material/material.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"
#include "lib/schemes/tlsph/loops/stress_window.hpp"

namespace plumb {

/// The d numbers from an address in the lanes of a register that has room for one more in 3D.
template <int d>
using VectorPack = Pack<d == 3 ? 4 : d>;
template <int d>
inline VectorPack<d> load_vector(const double* from) {
  double lanes[sizeof(VectorPack<d>) / sizeof(double)] = {};
  std::copy_n(from, d, lanes);
  return VectorPack<d>::load(lanes);
}

/// Calls use(n, vector) for the bonds first .. end of a row of one particle, with their vectors in a
/// register. In 3D the fourth lane holds the next bond's first number, so the last one is read apart.
template <int d, class Use>
inline void for_vectors(const double* vectors, std::int64_t first, std::int64_t end, Use&& use) {
  if (first == end) return;
  for (std::int64_t n = first; n + 1 < end; ++n) use(n, VectorPack<d>::load(vectors + n * d));
  use(end - 1, load_vector<d>(vectors + (end - 1) * d));
}

/// Deformation gradient of one particle, THEORY (10.1), by rows: (u_j - u_i)_a c_ij in one register.
template <int d>
inline Mat<d, Pack<1>> deformation_gradient_by_rows(const BondTable<d>& bonds, const Field& u, Index i) {
  using Real = VectorPack<d>;
  Real F[d], own[d];
  for (int a = 0; a < d; ++a) {
    own[a] = Real(u[a][i]);
    F[a] = load_vector<d>(bonds.identity.data() + (bonds.row[i] * d + a) * Index{d});
  }
  const double* at[d];
  for (int a = 0; a < d; ++a) at[a] = u[a] + i;
  const std::int32_t* offset = bonds.offset.data();
  for_vectors<d>(bonds.stencil.data(), bonds.begin[bonds.row[i]], bonds.begin[bonds.row[i] + 1],
                 [&](std::int64_t n, Real c) {
                   for (int a = 0; a < d; ++a) F[a] += (Real(at[a][offset[n]]) - own[a]) * c;
                 });
  Mat<d, Pack<1>> result;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) result(a, b) = F[a][b];
  return result;
}

/// Deformation gradients of one pack: F_i = sum_j (x_j - x_i) (x) c_ij, THEORY (3.1).
template <int d, int W>
inline Mat<d, Pack<W>> deformation_gradient(const BondTable<d>& bonds, const Field& u, Index pack) {
  if constexpr (W == 1 && d > 1) return deformation_gradient_by_rows<d>(bonds, u, pack);
  using Real = Pack<W>;
  const Index i = pack * W;
  const std::int32_t row = bonds.row[pack];
  Real own[d], F[d][d];
  for (int a = 0; a < d; ++a) own[a] = Real::load(u[a] + i);
  const double* identity = bonds.identity.data() + static_cast<Index>(row) * d * d * W;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) F[a][b] = Real::load(identity + (a * d + b) * W);
  const std::int64_t end = bonds.begin[row + 1];
  for (std::int64_t n = bonds.begin[row]; n < end; ++n) {
    const Index j = i + bonds.offset[n];
    const double* c = bonds.stencil.data() + n * d * W;
    Real weight[d];
    for (int b = 0; b < d; ++b) weight[b] = Real::load(c + b * W);
    for (int a = 0; a < d; ++a) {
      const Real du = Real::load(u[a] + j) - own[a];
      for (int b = 0; b < d; ++b) F[a][b] += du * weight[b];
    }
  }
  Mat<d, Real> result;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) result(a, b) = F[a][b];
  return result;
}

/// Deformation gradients of the next V slots of a block whose table has packs of W, as one pack: where rows
/// are of single particles, the material still works on whole packs. Behind the block's end: I.
template <int d, int W, int V, class DeformationGradient>
inline Mat<d, Pack<V>> gathered(DeformationGradient&& deformation_gradient_of_pack, Index slot, Index end) {
  if constexpr (W == V) {
    return deformation_gradient_of_pack(slot / W);
  } else {
    static_assert(W == 1);
    double lanes[d][d][V] = {};
    for (int a = 0; a < d; ++a) std::fill_n(lanes[a][a], V, 1.0);
    for (int lane = 0; lane < V && slot + lane < end; ++lane) {
      const Mat<d, Pack<1>> F = deformation_gradient_of_pack(slot + lane);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) lanes[a][b][lane] = F(a, b)[0];
    }
    Mat<d, Pack<V>> all;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) all(a, b) = Pack<V>::load(lanes[a][b]);
    return all;
  }
}

/// First Piola-Kirchhoff stress of one block into P, and F into `F_out` if a term needs it. Returns false if
/// some determinant is not positive (or not a number).
template <int d, int W, MaterialModel<d> M, class DeformationGradient>
bool stress_sweep(const M& material, DeformationGradient&& deformation_gradient_of_pack, const Block& block,
                  StressWindow& P, Field* F_out) {
  constexpr int V = native_width;
  using Real = Pack<V>;
  Real unsound(0);
  for (Index slot = block.begin(); slot < block.end(); slot += V) {
    const Mat<d, Real> F = gathered<d, W, V>(deformation_gradient_of_pack, slot, block.end());
    const Mat<d, Real> stress = material.first_piola(F);
    const Index place = P.place(slot);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        stress(a, b).store(P[a * d + b] + place);  // a block's memory is always whole
    if (F_out) {
      const Index count = std::min<Index>(V, block.end() - slot);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) {
          double values[V];
          F(a, b).store(values);
          std::copy_n(values, count, (*F_out)[a * d + b] + slot);
        }
    }
    unsound += not_positive(determinant<d, Real>(F));
  }
  double count = 0;
  for (int lane = 0; lane < V; ++lane) count += unsound[lane];
  return count == 0;
}

/// Internal force per unit reference volume of one block: f_i = P_i s_i + sum_j P_j a_ij, THEORY (5.1).
template <int d, int W>
void force_sweep(const BondTable<d>& bonds, const StressWindow& P, const Block& block, BlockForce<d>& force) {
  static_assert(W ==
                1);  // a pack of others may lie in two blocks; lattice_force_sweep() reads whole packs only
  using Real = Pack<W>;
  const double* weights = bonds.force_weights().data();
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    const std::int32_t row = bonds.row[pack];
    Real sums[d][d];  // by b of P_ab a_b as well: one chain of additions would wait for each of them
    const auto add = [&](Index j, const double* a_ij) {
      const Index place = P.place(j);
      Real weight[d];
      for (int b = 0; b < d; ++b) weight[b] = Real::load(a_ij + b * W);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) sums[a][b] += Real::load(P[a * d + b] + place) * weight[b];
    };
    for (auto& by_component : sums)
      for (auto& sum : by_component) sum = Real(0);
    add(i, bonds.own_force.data() + static_cast<Index>(row) * d * W);
    const std::int64_t end = bonds.begin[row + 1];
    for (std::int64_t n = bonds.begin[row]; n < end; ++n) add(i + bonds.offset[n], weights + n * d * W);
    for (int a = 0; a < d; ++a) {
      Real f = sums[a][0];
      for (int b = 1; b < d; ++b) f += sums[a][b];
      f.store(force.at(a, i));
    }
  }
}

/// Strain energy sum V W(F) of one block [J].
template <int d, int W, MaterialModel<d> M, class DeformationGradient>
double energy_sweep(const M& material, DeformationGradient&& deformation_gradient_of_pack, const Block& block,
                    const double* volume) {
  Pack<W> sum(0);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack)
    sum += material.energy(deformation_gradient_of_pack(pack)) * Pack<W>::load(volume + pack * W);
  double total = 0;
  for (int lane = 0; lane < W; ++lane) total += sum[lane];
  return total;
}

/// Squares of the current distances of one bond of one pack [m^2]; the largest double on lanes without it.
template <int d, int W>
inline Pack<W> square_distance(const BondTable<d>& bonds, const Field& u, Index pack, std::int64_t n) {
  using Real = Pack<W>;
  const Index i = pack * W;
  const double* X = bonds.separation.data() + n * d * W;
  Real square(0), reference(0);
  for (int a = 0; a < d; ++a) {
    const Real X_ij = Real::load(X + a * W);
    const Real x_ij = X_ij + Real::load(u[a] + i + bonds.offset[n]) - Real::load(u[a] + i);
    square += x_ij * x_ij;
    reference += X_ij * X_ij;
  }
  const Real none(std::numeric_limits<double>::max());
  return lesser_where_positive(square, none, reference);
}

/// Returns the smallest of the lanes.
template <int W>
inline double least_lane(Pack<W> values) {
  double least = values[0];
  for (int lane = 1; lane < W; ++lane) least = std::min(least, values[lane]);
  return least;
}

/// Square of the smallest current distance of neighbours in one block [m^2], each pair once.
template <int d, int W>
double distance_sweep(const BondTable<d>& bonds, const Field& u, const Block& block) {
  Pack<W> least(std::numeric_limits<double>::max());
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const std::int32_t row = bonds.row[pack];
    for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n)
      if (bonds.offset[n] > 0) least = min(square_distance<d, W>(bonds, u, pack, n), least);
  }
  return least_lane(least);
}

}  // namespace plumb
