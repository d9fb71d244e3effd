#include "lib/schemes/tlsph/loops/operator_rows.hpp"

#include <algorithm>

#include "lib/schemes/tlsph/bonds/each_bond.hpp"

namespace plumb {
namespace {

template <int d>
void add(Shares<d>& shares, Index other, const Mat<d>& table) {
  shares.push_back({other, static_cast<int>(shares.size()), table});
}

/// In the order of the others, each once. (Not by std::stable_sort: its buffer is not aligned as small matrices are.)
template <int d>
void tidy(Shares<d>& shares) {
  std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
    return a.other != b.other ? a.other < b.other : a.number < b.number;
  });
  std::size_t end = 0;
  for (const auto& share : shares) {
    if (end > 0 && shares[end - 1].other == share.other)
      shares[end - 1].table += share.table;
    else
      shares[end++] = share;
  }
  shares.erase(shares.begin() + static_cast<std::ptrdiff_t>(end), shares.end());
}

}  // namespace

template <int d>
OperatorRows<d>::OperatorRows(const Solid<d>& solid)
    : solid_(solid), particle_(solid.bonds.slots.count(), -1) {
  for (Index i = 0; i < solid.cloud.size(); ++i) particle_[solid.bonds.slots.of(i)] = i;
}

template <int d>
void OperatorRows<d>::gradient(Index i, Shares<d>& shares) const {
  const BondTable<d>& t = solid_.bonds;
  shares.clear();
  const Vec<d> ones = Vec<d>::Ones();
  Vec<d> sum = Vec<d>::Zero();
  const auto put = [&](Index j, const Vec<d>& c, const Vec<d>& signs) {
    add<d>(shares, j, signs * c.transpose());
    sum += c;
  };
  const Index own = t.slots.of(i);
  for_each_bond(t, own, [&](const BondEntry<d>& bond, const Vec<d>&) {
    put(particle_[bond.other], bond.vector(t.stencil), ones);
  });
  for_each_image(t, own, [&](const BondEntry<d>& bond, const Vec<d>& signs) {
    const Vec<d> c = bond.vector(t.mirror->stencil);
    if (c.squaredNorm() > 0) put(particle_[bond.other], c, signs);
  });
  put(i, -sum, ones);
  tidy<d>(shares);
}

template <int d>
void OperatorRows<d>::force(Index i, Shares<d>& shares) const {
  const BondTable<d>& t = solid_.bonds;
  shares.clear();
  const Vec<d> ones = Vec<d>::Ones();
  const Index slot = t.slots.of(i), row = t.row[slot / t.width], lane = slot % t.width;
  const auto put = [&](Index j, const Vec<d>& weight, const Vec<d>& signs) {
    add<d>(shares, j, -solid_.cloud.V[i] * signs * signs.cwiseProduct(weight).transpose());
  };
  Vec<d> own;
  for (int k = 0; k < d; ++k) own[k] = t.own_force[(row * d + k) * t.width + lane];
  if (t.mirror)
    for (int k = 0; k < d; ++k) own[k] += t.mirror->own_force[(row * d + k) * t.width + lane];
  put(i, own, ones);
  for_each_bond(t, slot, [&](const BondEntry<d>& bond, const Vec<d>&) {
    put(particle_[bond.other], bond.vector(t.force_weights()), ones);
  });
  for_each_image(t, slot, [&](const BondEntry<d>& bond, const Vec<d>& signs) {
    const Vec<d> a = bond.vector(t.mirror->force);
    if (a.squaredNorm() > 0) put(particle_[bond.other], a, signs);
  });
  tidy<d>(shares);
}

template class OperatorRows<1>;
template class OperatorRows<2>;
template class OperatorRows<3>;

}  // namespace plumb
