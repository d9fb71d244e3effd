#include "plumbline/solid/lattice_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "plumbline/gradient/same_value.hpp"

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

struct SumKey {
  std::int32_t shift, component;
  auto operator<=>(const SumKey&) const = default;
};
/// Per sum and aligned offset the weights by lane of the source.
using SourceRow = std::map<SumKey, std::map<std::int32_t, std::vector<double>>>;

/// offset = aligned + shift with |shift| <= width/2.
std::int32_t shift_of(std::int32_t offset, int width) {
  const auto in_pack = ((offset % width) + width) % width;
  return in_pack <= width / 2 ? in_pack : in_pack - width;
}

/// What the packs p-1, p, p+1 ask of sources that stand in pack p's place of their line.
template <int d>
SourceRow source_row(const BondTable<d>& bonds, Index p) {
  const int W = bonds.width;
  SourceRow sources;
  const auto ask = [&](Index target, std::int32_t offset, int component, double weight) {
    if (weight == 0) return;
    const std::int32_t shift = shift_of(offset, W);
    const Index place = target + shift;
    if (place / W != p) return;
    auto& weights = sources[{shift, component}][offset - shift];
    weights.resize(W, 0.0);
    weights[place % W] += weight;
  };
  for (Index pack = std::max<Index>(0, p - 1); pack <= std::min<Index>(p + 1, bonds.slots.packs() - 1);
       ++pack) {
    const Index row = bonds.row[pack];
    for (int lane = 0; lane < W; ++lane)
      for (int b = 0; b < d; ++b) {
        ask(pack * W + lane, 0, b, bonds.own_force[(row * d + b) * W + lane]);
        for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n)
          ask(pack * W + lane, bonds.offset[n], b, weights_of(bonds, bonds.force, n)[b * W + lane]);
      }
  }
  return sources;
}

/// Drops entries that are rounding errors of zero.
void drop_negligible(SourceRow& sources) {
  double scale = 0;
  const auto largest = [](const std::vector<double>& weights) {
    double most = 0;
    for (const double w : weights) most = std::max(most, std::abs(w));
    return most;
  };
  for (const auto& [key, entries] : sources)
    for (const auto& [offset, weights] : entries) scale = std::max(scale, largest(weights));
  for (auto& [key, entries] : sources)
    std::erase_if(entries, [&](const auto& entry) { return largest(entry.second) <= same * 1e-2 * scale; });
  std::erase_if(sources, [](const auto& sum) { return sum.second.empty(); });
}

template <int d>
void append_force_row(LatticeTable<d>& table, const BondTable<d>& bonds, Index pack) {
  SourceRow sources = source_row(bonds, pack);
  drop_negligible(sources);
  table.entry_begin.push_back(static_cast<std::int64_t>(table.entry_offset.size()));
  for (const auto& [key, entries] : sources) {
    for (const auto& [aligned, weights] : entries) {
      table.entry_offset.push_back(aligned);
      table.entry_weight.insert(table.entry_weight.end(), weights.begin(), weights.end());
    }
    table.sums.push_back({key.shift, key.component, static_cast<std::int64_t>(table.entry_offset.size())});
    table.most_shift = std::max(table.most_shift, std::abs(key.shift));
  }
  table.sum_begin.push_back(static_cast<std::int64_t>(table.sums.size()));
}

}  // namespace

template <int d>
std::size_t LatticeTable<d>::bytes() const {
  return (pair_stencil.size() + single_stencil.size() + entry_weight.size()) * sizeof(double) +
         (pair_offset.size() + single_offset.size() + entry_offset.size() + force_row.size()) *
             sizeof(std::int32_t) +
         (pair_begin.size() + single_begin.size() + sum_begin.size() + entry_begin.size()) *
             sizeof(std::int64_t) +
         sums.size() * sizeof(Sum);
}

template <int d>
LatticeTable<d> make_lattice_table(const BondTable<d>& bonds) {
  LatticeTable<d> table;
  table.width = bonds.width;
  table.pair_begin.push_back(0);
  table.single_begin.push_back(0);
  for (Index row = 0; row < bonds.rows(); ++row) append_stencil_row(table, bonds, row);

  ValueNumbering kinds;
  table.sum_begin.push_back(0);
  for (Index p = 0; p < bonds.slots.packs(); ++p) {
    const auto row_at = [&](Index q) -> std::int64_t {
      return q < 0 || q >= bonds.slots.packs() ? -1 : bonds.row[q];
    };
    const auto [number, is_new] = kinds.number({row_at(p - 1), row_at(p), row_at(p + 1)});
    table.force_row.push_back(number);
    if (is_new) append_force_row(table, bonds, p);
  }
  return table;
}

template struct LatticeTable<1>;
template struct LatticeTable<2>;
template struct LatticeTable<3>;
template LatticeTable<1> make_lattice_table<1>(const BondTable<1>&);
template LatticeTable<2> make_lattice_table<2>(const BondTable<2>&);
template LatticeTable<3> make_lattice_table<3>(const BondTable<3>&);

}  // namespace plumb
