#include "lib/schemes/tlsph/compatible/solver/bond_smoother.hpp"

#include <algorithm>
#include <cmath>

#include "lib/schemes/tlsph/compatible/solver/chebyshev.hpp"
#include "lib/schemes/tlsph/compatible/solver/lane_vector.hpp"

namespace plumb {
namespace {

/// Bonds from one whose numbers are asked for to the one at work: the loop is bound by the time of a read.
constexpr Index ahead = 20;

/// Particles along a curve that fills space: cubes of two spacings by the interleaved bits of their numbers.
template <int d>
std::vector<std::int32_t> along_curve(const std::vector<Vec<d>>& X) {
  constexpr int bits = 63 / d;
  Vec<d> low = X[0];
  for (const auto& x : X) low = low.cwiseMin(x);
  std::vector<std::pair<std::uint64_t, std::int32_t>> keys(X.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i) {
    std::uint64_t key = 0;
    for (int k = 0; k < d; ++k) {
      const auto cube = static_cast<std::uint64_t>((X[i][k] - low[k]) / 2);
      for (int bit = 0; bit < bits; ++bit) key |= (cube >> bit & 1) << (bit * d + k);
    }
    keys[i] = {key, static_cast<std::int32_t>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::int32_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace

template <int d>
BondSmoother<d> bond_smoother(const BondOperator<d>& N) {
  using Smoother = BondSmoother<d>;
  Smoother s;
  s.particle = along_curve<d>(N.X);
  std::vector<std::int32_t> place(s.particle.size());
  for (Index p = 0; p < s.places(); ++p) place[s.particle[p]] = static_cast<std::int32_t>(p);
  s.begin.reserve(s.particle.size() + 1);
  s.begin.push_back(0);
  for (const auto i : s.particle) s.begin.push_back(s.begin.back() + N.begin[i + 1] - N.begin[i]);
  s.bonds.assign(N.other.size() + ahead, {0, 0});
  s.half.resize(s.particle.size());
  s.diagonal.resize(s.particle.size());
  s.inverse_diagonal.resize(s.particle.size());
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < s.places(); ++p) {
    const Index i = s.particle[p];
    for (Index b = N.begin[i], to = s.begin[p]; b < N.begin[i + 1]; ++b, ++to)
      s.bonds[to] = {place[N.other[b]], static_cast<float>(N.weight[b])};
    typename BondOperator<d>::Square diagonal = BondOperator<d>::Square::Zero();
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) {
      typename BondOperator<d>::Row row;
      row << 1, N.half(i, b);
      diagonal += N.weight[b] * row * row.transpose();
    }
    s.diagonal[p] = diagonal.template cast<float>();
    s.half[p].setZero();
    s.half[p].template head<d>() = (0.5 * (N.X[i] - N.X[0])).template cast<float>();
    s.inverse_diagonal[p] = N.inverse_diagonal[i].template cast<float>();
  }
  return s;
}

namespace {

/// What the matrix answers to z at one place: to its own by the diagonal block, to the others bond by bond.
template <int d>
inline RoughBlock<d> answer(const BondSmoother<d>& s, const RoughMultipliers<d>& z, Index p) {
  using Lanes = LaneVector<float, lanes<d>>;
  const auto column = [&](Index place, int k) { return load_lanes<Lanes>(z[place].data() + k * lanes<d>); };
  const auto here = s.half[p];
  Lanes sum[d + 1];
  for (int k = 0; k <= d; ++k) {
    sum[k] = column(p, 0) * s.diagonal[p](0, k);
    for (int m = 1; m <= d; ++m) sum[k] += column(p, m) * s.diagonal[p](m, k);
  }
  for (Index b = s.begin[p]; b < s.begin[p + 1]; ++b) {
    const auto bond = s.bonds[b];
    const std::int32_t soon = s.bonds[b + ahead].other;  // of the particles that follow, too
    __builtin_prefetch(z[soon].data());
    __builtin_prefetch(s.half[soon].data());
    float half[d];
    for (int k = 0; k < d; ++k) half[k] = s.half[bond.other][k] - here[k];
    Lanes t = half[0] * column(bond.other, 1) - column(bond.other, 0);
    for (int k = 1; k < d; ++k) t += half[k] * column(bond.other, 1 + k);
    t *= bond.weight;
    sum[0] += t;
    for (int k = 0; k < d; ++k) sum[1 + k] += half[k] * t;
  }
  RoughBlock<d> result;
  for (int k = 0; k <= d; ++k) store_lanes(sum[k], result.data() + k * lanes<d>);
  return result;
}

}  // namespace

template <int d>
void smooth(const BondSmoother<d>& s, int sweeps, BondWork<d>& work) {
  // no structured binding: clang 14 lets none into a parallel loop
  auto &r = work.r, &x = work.x, &z = work.z, &next = work.next;
  const auto first = chebyshev(1, smoothing_bound);
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < s.places(); ++p)
    x[p] = z[p] = static_cast<float>(first.fresh) * (r[p] * s.inverse_diagonal[p]);
  for (int n = 2; n <= sweeps + 1; ++n) {
    const auto step = chebyshev(n, smoothing_bound);
    const auto old = static_cast<float>(step.old), fresh = static_cast<float>(step.fresh);
    const bool last = n > sweeps;
#pragma omp parallel for schedule(static)
    for (Index p = 0; p < s.places(); ++p) {
      r[p] -= answer(s, z, p);
      if (last) continue;
      next[p] = old * z[p] + fresh * (r[p] * s.inverse_diagonal[p]);
      x[p] += next[p];
    }
    std::swap(z, next);
  }
}

#define PLUMB_INSTANTIATE(d)                                         \
  template BondSmoother<d> bond_smoother<d>(const BondOperator<d>&); \
  template void smooth<d>(const BondSmoother<d>&, int, BondWork<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
