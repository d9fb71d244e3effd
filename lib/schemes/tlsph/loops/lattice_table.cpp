#include "lib/schemes/tlsph/loops/lattice_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lib/core/shrink.hpp"
#include "lib/schemes/tlsph/bonds/same_value.hpp"

namespace plumb {
namespace {

/// Weights are equal up to the rounding of the corrections, some 1e-15 of the largest of their row.
constexpr double same = 1e-13;

/// Where the weights of one bond start: d x width numbers.
template <int d>
const double* weights_of(const BondTable<d>& bonds, const AlignedVector& all, std::int64_t n) {
  return all.data() + n * d * bonds.width;
}

template <int d>
bool antisymmetric(const double* plus, const double* minus, int width, double scale) {
  for (int k = 0; k < d * width; ++k)
    if (std::abs(plus[k] + minus[k]) > same * scale) return false;
  return true;
}

template <int d>
void append_stencil_row(LatticeTable<d>& table, const BondTable<d>& bonds, Index row) {
  const std::int64_t begin = bonds.begin[row], end = bonds.begin[row + 1];
  const Index size = d * bonds.width;
  double scale = 0;
  std::map<std::int32_t, std::int64_t> at;
  for (std::int64_t n = begin; n < end; ++n) {
    at[bonds.offset[n]] = n;
    for (Index k = 0; k < size; ++k)
      scale = std::max(scale, std::abs(weights_of(bonds, bonds.stencil, n)[k]));
  }
  for (std::int64_t n = begin; n < end; ++n) {
    const double* plus = weights_of(bonds, bonds.stencil, n);
    const auto partner = at.find(-bonds.offset[n]);
    const double* minus = partner == at.end() ? nullptr : weights_of(bonds, bonds.stencil, partner->second);
    if (minus && antisymmetric<d>(plus, minus, bonds.width, scale)) {
      if (bonds.offset[n] < 0) continue;
      table.pair_offset.push_back(bonds.offset[n]);
      for (Index k = 0; k < size; ++k) table.pair_stencil.push_back(0.5 * (plus[k] - minus[k]));
    } else {
      table.single_offset.push_back(bonds.offset[n]);
      table.single_stencil.insert(table.single_stencil.end(), plus, plus + size);
    }
  }
  table.pair_begin.push_back(static_cast<std::int64_t>(table.pair_offset.size()));
  table.single_begin.push_back(static_cast<std::int64_t>(table.single_offset.size()));
}

/// One aligned stress: the weights by shift + most_shift and lane of the source.
struct SourceKey {
  std::int32_t component, aligned;
  auto operator<=>(const SourceKey&) const = default;
};
using ShiftWeights = std::vector<std::vector<double>>;
using SourceMap = std::map<SourceKey, ShiftWeights>;

/// offset = aligned + shift with |shift| <= width/2.
std::int32_t shift_of(std::int32_t offset, int width) {
  const auto in_pack = ((offset % width) + width) % width;
  return in_pack <= width / 2 ? in_pack : in_pack - width;
}

/// What the packs p-1, p, p+1 ask of sources that stand in pack p's place of their line.
template <int d>
SourceMap sources_of(const BondTable<d>& bonds, Index p, int most_shift) {
  const int W = bonds.width;
  SourceMap sources;
  const auto ask = [&](Index target, std::int32_t offset, int component, double weight) {
    if (weight == 0) return;
    const std::int32_t shift = shift_of(offset, W);
    const Index place = target + shift;
    if ((place + W) / W - 1 != p) return;  // rounded down: wide supports ask places before the first pack
    auto& weights = sources[{component, offset - shift}];
    weights.resize(2 * most_shift + 1, std::vector<double>(W, 0.0));
    weights[most_shift + shift][place - p * W] += weight;
  };
  for (Index pack = std::max<Index>(0, p - 1); pack <= std::min<Index>(p + 1, bonds.slots.packs() - 1);
       ++pack) {
    const Index row = bonds.row[pack];
    for (int lane = 0; lane < W; ++lane)
      for (int b = 0; b < d; ++b) {
        ask(pack * W + lane, 0, b, bonds.own_force[(row * d + b) * W + lane]);
        for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n)
          ask(pack * W + lane, bonds.offset[n], b, weights_of(bonds, bonds.force_weights(), n)[b * W + lane]);
      }
  }
  return sources;
}

/// E_0 .. E_m and O_1 .. O_m of one source, and which of them are more than rounding errors of zero.
struct Parts {
  std::vector<std::vector<double>> even, odd;
  bool has_even = false, has_odd = false;
};
Parts parts_of(const ShiftWeights& weights, double negligible) {
  const int m = static_cast<int>(weights.size() / 2);
  const auto W = weights[0].size();
  Parts parts{{weights[m]}, {}};
  for (int k = 1; k <= m; ++k) {
    parts.even.emplace_back(W);
    parts.odd.emplace_back(W);
    for (std::size_t lane = 0; lane < W; ++lane) {
      parts.even.back()[lane] = 0.5 * (weights[m + k][lane] + weights[m - k][lane]);
      parts.odd.back()[lane] = 0.5 * (weights[m + k][lane] - weights[m - k][lane]);
    }
  }
  const auto counts = [&](const std::vector<std::vector<double>>& all) {
    for (const auto& pack : all)
      for (const double w : pack)
        if (std::abs(w) > negligible) return true;
    return false;
  };
  parts.has_even = counts(parts.even);
  parts.has_odd = counts(parts.odd);
  return parts;
}

template <int d>
void append_source_row(LatticeTable<d>& table, const BondTable<d>& bonds, Index pack) {
  const SourceMap sources = sources_of(bonds, pack, table.most_shift);
  double scale = 0;
  for (const auto& [key, weights] : sources)
    for (const auto& by_lane : weights)
      for (const double w : by_lane) scale = std::max(scale, std::abs(w));
  typename LatticeTable<d>::SourceRow row{};
  row.source = static_cast<std::int64_t>(table.sources.size());
  row.weight = static_cast<std::int64_t>(table.source_weight.size());
  const auto append = [&](bool even, bool odd) {
    std::int32_t count = 0;
    for (const auto& [key, weights] : sources) {
      const Parts parts = parts_of(weights, same * 1e-2 * scale);
      if (parts.has_even != even || parts.has_odd != odd) continue;
      ++count;
      table.sources.push_back({key.aligned, key.component});
      if (even)
        for (const auto& pack_of_weights : parts.even)
          table.source_weight.insert(table.source_weight.end(), pack_of_weights.begin(),
                                     pack_of_weights.end());
      if (odd)
        for (const auto& pack_of_weights : parts.odd)
          table.source_weight.insert(table.source_weight.end(), pack_of_weights.begin(),
                                     pack_of_weights.end());
    }
    return count;
  };
  row.evens = append(true, false);
  row.odds = append(false, true);
  row.mixed = append(true, true);
  table.source_rows.push_back(row);
}

}  // namespace

template <int d>
std::size_t LatticeTable<d>::bytes() const {
  return (pair_stencil.size() + single_stencil.size() + source_weight.size()) * sizeof(double) +
         (pair_offset.size() + single_offset.size() + force_row.size()) * sizeof(std::int32_t) +
         (pair_begin.size() + single_begin.size()) * sizeof(std::int64_t) + sources.size() * sizeof(Source) +
         source_rows.size() * sizeof(SourceRow);
}

template <int d>
LatticeTable<d> make_lattice_table(const BondTable<d>& bonds) {
  LatticeTable<d> table;
  table.width = bonds.width;
  table.pair_begin.push_back(0);
  table.single_begin.push_back(0);
  for (Index row = 0; row < bonds.rows(); ++row) append_stencil_row(table, bonds, row);

  for (const auto offset : bonds.offset)
    table.most_shift = std::max(table.most_shift, std::abs(shift_of(offset, bonds.width)));
  ValueNumbering kinds;
  for (Index p = -1; p <= bonds.slots.packs(); ++p) {
    const auto row_at = [&](Index q) -> std::int64_t {
      return q < 0 || q >= bonds.slots.packs() ? -1 : bonds.row[q];
    };
    const auto [number, is_new] = kinds.number({row_at(p - 1), row_at(p), row_at(p + 1)});
    table.force_row.push_back(number);
    if (is_new) append_source_row(table, bonds, p);
  }
  shrink_to_fit(table.pair_begin, table.single_begin, table.pair_offset, table.single_offset,
                table.pair_stencil, table.single_stencil, table.force_row, table.source_rows, table.sources,
                table.source_weight);
  return table;
}

template struct LatticeTable<1>;
template struct LatticeTable<2>;
template struct LatticeTable<3>;
template LatticeTable<1> make_lattice_table<1>(const BondTable<1>&);
template LatticeTable<2> make_lattice_table<2>(const BondTable<2>&);
template LatticeTable<3> make_lattice_table<3>(const BondTable<3>&);

}  // namespace plumb
