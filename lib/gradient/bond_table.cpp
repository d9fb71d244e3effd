#include "plumbline/gradient/bond_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "plumbline/gradient/same_value.hpp"

namespace plumb {
namespace {

/// A row for one slot, by offset; what is packed later.
template <int d>
struct SlotBond {
  std::int32_t offset;
  Vec<d> separation, stencil, force;
  double laplacian, outer_laplacian;
};
template <int d>
struct SlotRow {
  std::vector<SlotBond<d>> bonds;
  Mat<d> identity = Mat<d>::Zero();
  Vec<d> own_force = Vec<d>::Zero();
  double own_outer = 0;
};

/// For every particle the number of its kind, and for every kind one particle that stands for it.
struct Kinds {
  std::vector<std::int32_t> of;
  std::vector<Index> representative;
};

/// Every particle on its own: clouds without repetition.
Kinds all_different(Index n) {
  Kinds kinds;
  kinds.of.resize(n);
  kinds.representative.resize(n);
  for (Index i = 0; i < n; ++i) kinds.of[i] = static_cast<std::int32_t>(kinds.representative[i] = i);
  return kinds;
}

template <class Signature>
Kinds group(Index n, Signature&& signature) {
  Kinds kinds;
  kinds.of.resize(n);
  ValueNumbering numbering;
  std::vector<std::int64_t> value;
  for (Index i = 0; i < n; ++i) {
    value.clear();
    signature(i, value);
    const auto [number, is_new] = numbering.number(value);
    kinds.of[i] = number;
    if (is_new) kinds.representative.push_back(i);
  }
  return kinds;
}

/// Particles with the same separations and volumes (to 2^-30 of the spacing) at the same offsets are of one
/// kind.
template <int d>
Kinds kinds_by_neighbourhood(const Cloud<d>& cloud, const Neighbours& all, const Slots& slots) {
  if (cloud.line == 0) return all_different(cloud.size());
  const double length = 0x1p30 / cloud.spacing, volume = 0x1p30 / std::pow(cloud.spacing, d);
  return group(cloud.size(), [&](Index i, std::vector<std::int64_t>& value) {
    for (const auto j : all.of(i)) {
      value.push_back(slots.of(j) - slots.of(i));
      for (int k = 0; k < d; ++k) value.push_back(std::llround((cloud.X[j][k] - cloud.X[i][k]) * length));
      value.push_back(std::llround(cloud.V[j] * volume));
    }
  });
}

/// Particles whose bonds have the same constants (to 2^-30 of their size) at the same offsets are of one
/// kind.
template <int d>
Kinds kinds_by_stencil(const Cloud<d>& cloud, const Slots& slots,
                       const std::vector<std::vector<BondConstants<d>>>& bonds) {
  if (cloud.line == 0) return all_different(cloud.size());
  const double per_length = 0x1p30 * cloud.spacing, volume = 0x1p30 / std::pow(cloud.spacing, d);
  return group(cloud.size(), [&](Index i, std::vector<std::int64_t>& value) {
    value.push_back(std::llround(cloud.V[i] * volume));
    for (const auto& bond : bonds[i]) {
      value.push_back(slots.of(bond.other) - slots.of(i));
      for (int k = 0; k < d; ++k) value.push_back(std::llround(bond.stencil[k] * per_length));
    }
  });
}

/// The row of particle i depends on its own kind and those of its neighbours.
template <int d>
Kinds kinds_by_neighbours(const Cloud<d>& cloud, const Neighbours& all, const Kinds& own) {
  if (cloud.line == 0) return all_different(cloud.size());
  return group(cloud.size(), [&](Index i, std::vector<std::int64_t>& value) {
    value.push_back(own.of[i]);
    for (const auto j : all.of(i)) value.push_back(own.of[j]);
  });
}

/// Bonds of every kind, computed at its representative.
template <int d>
std::vector<std::vector<BondConstants<d>>> bonds_of_kinds(const Cloud<d>& cloud, const Neighbours& all,
                                                          const Kinds& kinds, const BondOptions<d>& options) {
  const Index n = static_cast<Index>(kinds.representative.size());
  std::vector<std::vector<BondConstants<d>>> bonds(n);
  std::vector<std::exception_ptr> failures(n);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < n; ++k) {
    const Index i = kinds.representative[k];
    try {
      bonds[k] = bonds_of<d>(cloud, all.of(i), i, options);
    } catch (...) {
      failures[k] = std::current_exception();
    }
  }
  for (const auto& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return bonds;
}

/// Position of particle j among the sorted neighbours of i, not counting i itself.
Index place_of(std::span<const std::int32_t> neighbours, Index i, Index j) {
  const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), static_cast<std::int32_t>(j));
  return (at - neighbours.begin()) - (j > i ? 1 : 0);
}

template <int d>
SlotRow<d> slot_row(Index i, const Cloud<d>& cloud, const Neighbours& all, const Slots& slots,
                    const Kinds& kinds, const std::vector<std::vector<BondConstants<d>>>& bonds,
                    const BondOptions<d>& options) {
  SlotRow<d> row;
  const auto& mine = bonds[kinds.of[i]];
  std::size_t n = 0;
  for (const auto j : all.of(i)) {
    if (j == i) continue;
    const BondConstants<d>& ij = mine[n++];
    const BondConstants<d>& ji = bonds[kinds.of[j]][place_of(all.of(j), j, i)];
    const PairData<d> pair{cloud.V[i], cloud.V[j], ij.stencil, ji.stencil, ij.gradient, ji.gradient};
    SlotBond<d> bond;
    bond.offset = static_cast<std::int32_t>(slots.of(j) - slots.of(i));
    bond.separation = ij.separation;
    bond.stencil = ij.stencil;
    bond.force = options.momentum.other(pair);
    bond.laplacian = cloud.V[j] * ij.laplacian;
    bond.outer_laplacian =
        cloud.V[j] * (options.outer_transpose ? ji.laplacian : 0.5 * (ij.laplacian + ji.laplacian));
    row.own_outer += cloud.V[j] * (ji.laplacian - ij.laplacian);
    row.bonds.push_back(bond);
    row.identity += ij.separation * ij.stencil.transpose();
    row.own_force += options.momentum.own(pair);
  }
  return row;
}

/// Appends the row of one pack: the union of its lanes' offsets, ascending, with zero weights where a lane
/// lacks one.
template <int d>
void append_row(BondTable<d>& table, const std::vector<const SlotRow<d>*>& lanes,
                const BondOptions<d>& options) {
  const int W = table.width;
  std::map<std::int32_t, std::vector<const SlotBond<d>*>> by_offset;
  for (int lane = 0; lane < W; ++lane)
    if (lanes[lane])
      for (const auto& bond : lanes[lane]->bonds) {
        auto& entry = by_offset[bond.offset];
        entry.resize(W, nullptr);
        entry[lane] = &bond;
      }
  const auto put = [&](AlignedVector& to, auto&& value) {
    for (int lane = 0; lane < W; ++lane) to.push_back(value(lane));
  };
  for (const auto& offset_and_entry : by_offset) {  // no binding: clang 14 cannot capture one
    const auto& entry = offset_and_entry.second;
    table.offset.push_back(offset_and_entry.first);
    for (int k = 0; k < d; ++k) {
      put(table.separation, [&](int l) { return entry[l] ? entry[l]->separation[k] : 0.0; });
      put(table.stencil, [&](int l) { return entry[l] ? entry[l]->stencil[k] : 0.0; });
      put(table.force, [&](int l) { return entry[l] ? entry[l]->force[k] : 0.0; });
    }
    if (!options.laplacian) continue;
    put(table.laplacian, [&](int l) { return entry[l] ? entry[l]->laplacian : 0.0; });
    put(table.outer_laplacian, [&](int l) { return entry[l] ? entry[l]->outer_laplacian : 0.0; });
  }
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b)
      put(table.identity, [&](int l) { return lanes[l] ? lanes[l]->identity(a, b) : (a == b ? 1.0 : 0.0); });
  for (int a = 0; a < d; ++a)
    put(table.own_force, [&](int l) { return lanes[l] ? lanes[l]->own_force[a] : 0.0; });
  if (options.laplacian && options.outer_transpose)
    put(table.own_outer, [&](int l) { return lanes[l] ? lanes[l]->own_outer : 0.0; });
  table.begin.push_back(static_cast<std::int64_t>(table.offset.size()));
}

}  // namespace

template <int d>
std::size_t BondTable<d>::bytes() const {
  const std::size_t reals = separation.size() + stencil.size() + force.size() + identity.size() +
                            own_force.size() + laplacian.size() + outer_laplacian.size() + own_outer.size();
  return reals * sizeof(double) + (row.size() + offset.size()) * sizeof(std::int32_t) +
         begin.size() * sizeof(std::int64_t);
}

template <int d>
BondTable<d> make_bond_table(Cloud<d>& cloud, const BondOptions<d>& options) {
  BondTable<d> table;
  table.slots = make_slots(cloud.size(), cloud.line);
  table.width = table.slots.width;
  const Neighbours all = find_neighbours<d>(cloud, options.kernel.support * options.smoothing_length);
  Kinds neighbourhoods =
      options.project ? all_different(cloud.size()) : kinds_by_neighbourhood<d>(cloud, all, table.slots);
  auto bonds = bonds_of_kinds<d>(cloud, all, neighbourhoods, options);
  if (options.project) {
    options.project(cloud, all, bonds);
    neighbourhoods = kinds_by_stencil<d>(cloud, table.slots, bonds);
    std::vector<std::vector<BondConstants<d>>> shared;
    for (const Index i : neighbourhoods.representative) shared.push_back(std::move(bonds[i]));
    bonds = std::move(shared);
  }
  const Kinds kinds = kinds_by_neighbours<d>(cloud, all, neighbourhoods);

  std::vector<SlotRow<d>> rows(kinds.representative.size());
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < static_cast<Index>(rows.size()); ++k)
    rows[k] = slot_row<d>(kinds.representative[k], cloud, all, table.slots, neighbourhoods, bonds, options);

  std::vector<std::int32_t> row_of_slot(table.slots.count(), -1);
  for (Index i = 0; i < cloud.size(); ++i) {
    row_of_slot[table.slots.of(i)] = kinds.of[i];
    const auto neighbours = static_cast<std::int64_t>(all.of(i).size()) - 1;
    table.pairs += neighbours;
    table.most_neighbours = std::max(table.most_neighbours, neighbours);
  }
  const int W = table.width;
  table.begin.push_back(0);
  const Kinds packs = cloud.line == 0
                          ? all_different(table.slots.packs())
                          : group(table.slots.packs(), [&](Index p, std::vector<std::int64_t>& value) {
                              value.assign(row_of_slot.begin() + p * W, row_of_slot.begin() + (p + 1) * W);
                            });
  table.row = packs.of;
  std::vector<const SlotRow<d>*> lanes(W);
  for (const Index p : packs.representative) {
    for (int lane = 0; lane < W; ++lane) {
      const auto r = row_of_slot[p * W + lane];
      lanes[lane] = r < 0 ? nullptr : &rows[r];
    }
    append_row<d>(table, lanes, options);
  }
  for (const auto o : table.offset) table.margin = std::max<Index>(table.margin, std::abs(o));
  table.margin += W;
  for (auto* values :
       {&table.separation, &table.stencil, &table.force, &table.laplacian, &table.outer_laplacian})
    values->shrink_to_fit();  // of a cloud with a row per particle these are most of the memory
  table.offset.shrink_to_fit();
  return table;
}

template struct BondTable<1>;
template struct BondTable<2>;
template struct BondTable<3>;
template BondTable<1> make_bond_table<1>(Cloud<1>&, const BondOptions<1>&);
template BondTable<2> make_bond_table<2>(Cloud<2>&, const BondOptions<2>&);
template BondTable<3> make_bond_table<3>(Cloud<3>&, const BondOptions<3>&);

}  // namespace plumb
