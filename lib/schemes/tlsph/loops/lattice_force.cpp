#include <utility>

#include "lib/schemes/tlsph/loops/lattice_sweeps.hpp"

namespace plumb {
namespace {

/// The sums S_shift of THEORY (10.3) over the packs of one block and one more on either side.
template <int d, int W, int m>
class ShiftedSums {
 public:
  double* at(int shift, int component, Index pack_in_block) {
    return values_[shift + m][component] + (pack_in_block + 1) * W;
  }

 private:
  alignas(64) double values_[2 * m + 1][d][block_slots + 2 * W];
};

/// Adds `count` sources to N sums per component of the force; returns where the next weights are.
template <int d, int W, int N>
inline const double* add_sources(const typename LatticeTable<d>::Source* source, std::int32_t count,
                                 const double* weights, const StressWindow& P, Index i, Pack<W> (*sums)[d]) {
  using Real = Pack<W>;
  for (std::int32_t n = 0; n < count; ++n, weights += N * W) {
    const Index from = P.place(i + source[n].offset);
    Real weight[N];
    for (int k = 0; k < N; ++k) weight[k] = Real::load_once(weights + k * W);
    for (int a = 0; a < d; ++a) {
      const Real stress = Real::load_once(P[a * d + source[n].component] + from);
      for (int k = 0; k < N; ++k) sums[k][a] += stress * weight[k];
    }
  }
  return weights;
}

/// The sums of one source pack, by their even and odd parts (10.4).
template <int d, int W, int m>
inline void sum_sources(const LatticeTable<d>& table, const StressWindow& P, Index pack, Index pack_in_block,
                        ShiftedSums<d, W, m>& sums) {
  using Real = Pack<W>;
  const auto& row = table.source_rows[table.force_row[pack + 1]];
  const auto* source = table.sources.data() + row.source;
  const double* weights = table.source_weight.data() + row.weight;
  Real part[2 * m + 1][d];  // E_0 .. E_m, O_1 .. O_m
  for (auto& by_component : part)
    for (auto& value : by_component) value = Real(0);
  const Index i = pack * W;
  weights = add_sources<d, W, m + 1>(source, row.evens, weights, P, i, part);
  source += row.evens;
  weights = add_sources<d, W, m>(source, row.odds, weights, P, i, part + m + 1);
  source += row.odds;
  add_sources<d, W, 2 * m + 1>(source, row.mixed, weights, P, i, part);
  for (int a = 0; a < d; ++a) {
    part[0][a].store(sums.at(0, a, pack_in_block));
    for (int k = 1; k <= m; ++k) {
      (part[k][a] + part[m + k][a]).store(sums.at(k, a, pack_in_block));
      (part[k][a] - part[m + k][a]).store(sums.at(-k, a, pack_in_block));
    }
  }
}

template <int d, int W, int m>
void force_with_shifts(const LatticeTable<d>& table, const StressWindow& P, const Block& block,
                       BlockForce<d>& force) {
  using Real = Pack<W>;
  ShiftedSums<d, W, m> sums;
  for (Index p = block.first_pack - 1; p <= block.end_pack; ++p)
    sum_sources<d, W, m>(table, P, p, p - block.first_pack, sums);
  for (Index p = block.first_pack; p < block.end_pack; ++p)
    for (int a = 0; a < d; ++a) {
      Real f(0);
      for (int shift = -m; shift <= m; ++shift)
        f += Real::load(sums.at(shift, a, p - block.first_pack) + shift);
      f.store(force.at(a, p * W));
    }
}

}  // namespace

template <int d>
void lattice_force_sweep(const LatticeTable<d>& table, const StressWindow& P, const Block& block,
                         BlockForce<d>& force) {
  constexpr int W = native_width;
  [&]<int... m>(std::integer_sequence<int, m...>) {
    ((table.most_shift == m + 1 ? force_with_shifts<d, W, m + 1>(table, P, block, force) : void()), ...);
  }
  (std::make_integer_sequence<int, W / 2>{});
}

template void lattice_force_sweep<1>(const LatticeTable<1>&, const StressWindow&, const Block&,
                                     BlockForce<1>&);
template void lattice_force_sweep<2>(const LatticeTable<2>&, const StressWindow&, const Block&,
                                     BlockForce<2>&);
template void lattice_force_sweep<3>(const LatticeTable<3>&, const StressWindow&, const Block&,
                                     BlockForce<3>&);

}  // namespace plumb
