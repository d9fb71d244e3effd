#pragma once
#include "lib/core/roots.hpp"
#include "lib/schemes/gather.hpp"
#include "lib/schemes/mixed/kernel_sums.hpp"
#include "lib/schemes/mixed/mixed_bonds.hpp"
#include "lib/schemes/tensors.hpp"

/// The smoothed velocity of Algorithm 1, line 15: sum V_b v_b W~_b(a) with the corrected kernel (38) to (40).
namespace plumb {

/// Weights of one pack. r(n, j): vector that the kernel sees; arm(n, j): separation in the configuration of
/// the correction.
template <int d, int W, class R, class Arm>
void smoothing_of_pack(MixedBonds<d>& bonds, Index pack, R&& r, Arm&& arm) {
  using Real = Pack<W>;
  const BondTable<d>& t = bonds.table;
  const Real own = Real::load(bonds.strength[0] + pack * W);
  Real sum = own;
  Vec<d, Real> first = zero_vector<d, Real>();
  Mat<d, Real> second = zero_tensor<d, Real>();
  for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
    const Vec<d, Real> X = bond_vector<d, W>(t.separation, n), seen = r(n, j), y = arm(n, j);
    const Real there = Real(1) - not_positive(dot<d, Real>(X, X));  // 0 where a lane lacks the neighbour
    const Real weight =
        there * Real::load(bonds.strength[0] + j) *
        kernel_value<Real>(sqrt(dot<d, Real>(seen, seen)), Real::load(bonds.inverse_h[0] + j));
    weight.store(bonds.smoothing.data() + n * W);
    sum += weight;
    for (int k = 0; k < d; ++k) first[k] += weight * y[k];
    add_outer<d, Real>(second, (weight * y).eval(), y);
  });
  for (int k = 0; k < d; ++k) second(k, k) += not_positive(own);  // empty slots
  const Vec<d, Real> beta = transpose_times<d, Real>(inverse_transpose<d, Real>(second), first);
  const Real total = sum - dot<d, Real>(beta, first) + not_positive(own);
  for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
    const Real weight = bond_number<W>(bonds.smoothing, n);
    (weight * (Real(1) - dot<d, Real>(beta, arm(n, j))) / total).store(bonds.smoothing.data() + n * W);
  });
  (own / total).store(bonds.own_smoothing.data() + t.row[pack] * W);
}

/// Weights of the material configuration.
template <int d>
void make_smoothing(MixedBonds<d>& bonds) {
  const BondTable<d>& t = bonds.table;
  bonds.smoothing.assign(t.offset.size() * static_cast<std::size_t>(t.width), 0.0);
  bonds.own_smoothing.assign(static_cast<std::size_t>(t.rows() * t.width), 0.0);
  const auto X = [&]<int W>(std::int64_t n) { return bond_vector<d, W>(t.separation, n); };
  with_width(t, [&]<int W>() {
    std::vector<char> done(static_cast<std::size_t>(t.rows()));
    for (Index pack = 0; pack < t.slots.packs(); ++pack) {
      if (done[t.row[pack]]++) continue;
      const auto r = [&](std::int64_t n, Index) { return X.template operator()<W>(n); };
      smoothing_of_pack<d, W>(bonds, pack, r, r);
    }
  });
}

/// The smoothed velocity of one pack.
template <int d, int W>
Vec<d, Pack<W>> smoothed_velocity(const MixedBonds<d>& bonds, const Field& v, Index pack) {
  using Real = Pack<W>;
  const Real own = Real::load(bonds.own_smoothing.data() + bonds.table.row[pack] * W);
  Vec<d, Real> sum = load_vector<d, W>(v, pack * W);
  for (int k = 0; k < d; ++k) sum[k] *= own;
  for_bonds<d, W>(bonds.table, pack, [&](std::int64_t n, Index j) {
    const Real weight = bond_number<W>(bonds.smoothing, n);
    for (int k = 0; k < d; ++k) sum[k] += weight * Real::load(v[k] + j);
  });
  return sum;
}

}  // namespace plumb
