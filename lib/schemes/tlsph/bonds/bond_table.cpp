#include "lib/schemes/tlsph/bonds/bond_table.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "lib/core/shrink.hpp"
#include "lib/schemes/tlsph/bonds/append_image_row.hpp"

namespace plumb {
namespace {

/// Bonds of every kind, computed at its representative.
template <int d>
std::vector<std::vector<BondConstants<d>>> bonds_of_kinds(const Surroundings<d>& seen, const Kinds& kinds,
                                                          const BondOptions<d>& options) {
  const auto n = static_cast<Index>(kinds.representative.size());
  std::vector<std::vector<BondConstants<d>>> bonds(n);
  std::vector<std::exception_ptr> failures(n);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < n; ++k) {
    const Index i = kinds.representative[k];
    try {
      bonds[k] = bonds_of<d>(seen.cloud, seen.all.of(i), i, options);
    } catch (...) {
      failures[k] = std::current_exception();
    }
  }
  for (const auto& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return bonds;
}

/// The row's force weights as options.adjust_force wants them.
template <int d>
void adjust(SlotRow<d>& row, Index i, const Surroundings<d>& seen, const BondOptions<d>& options) {
  std::vector<Index> others;
  std::vector<Vec<d>> force;
  for (const auto j : seen.all.of(i))
    if (j != i) others.push_back(j);
  for (const auto& bond : row.bonds) force.push_back(bond.force);
  options.adjust_force(seen.cloud, i, others, force, row.own_force);
  for (std::size_t n = 0; n < force.size(); ++n) row.bonds[n].force = force[n];
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

/// The row of every slot; -1 where there is no particle. Counts neighbours.
template <int d>
std::vector<std::int32_t> rows_of_slots(const Surroundings<d>& seen, const Kinds& kinds,
                                        BondTable<d>& table) {
  std::vector<std::int32_t> row_of_slot(table.slots.count(), -1);
  for (Index i = 0; i < seen.particles(); ++i) {
    row_of_slot[table.slots.of(i)] = kinds.of[i];
    const auto neighbours = static_cast<std::int64_t>(seen.all.of(i).size()) - 1;
    table.pairs += neighbours;
    table.most_neighbours = std::max(table.most_neighbours, neighbours);
  }
  return row_of_slot;
}

/// The table from the rows of its particles.
template <int d>
void pack(BondTable<d>& table, const std::vector<SlotRow<d>>& rows,
          const std::vector<std::int32_t>& row_of_slot, const BondOptions<d>& options) {
  const int W = table.width;
  table.begin.push_back(0);
  if (!options.walls.empty()) table.mirror = MirrorBonds<d>{options.walls, {0}, {}, {}, {}, {}, {}, {}, {}};
  const Kinds packs = kinds_of_packs(table.slots, row_of_slot);
  table.row = packs.of;
  std::vector<const SlotRow<d>*> lanes(W);
  for (const Index p : packs.representative) {
    for (int lane = 0; lane < W; ++lane) {
      const auto r = row_of_slot[p * W + lane];
      lanes[lane] = r < 0 ? nullptr : &rows[r];
    }
    append_row<d>(table, lanes, options);
    if (table.mirror) append_image_row<d>(*table.mirror, W, lanes, options.laplacian);
  }
  for (const auto o : table.offset) table.margin = std::max<Index>(table.margin, std::abs(o));
  table.margin += W;  // the particle of an image is no farther than the image, so it is a neighbour, too
}

/// Drops the force weights if they are the stencil's numbers, up to the rounding of one division and one
/// product: V_i c_ij = -V_j c_ji makes (5.2) and (5.3) the same, THEORY (11.4).
template <int d>
void share_vectors(BondTable<d>& table) {
  double most = 0, difference = 0;
  for (std::size_t n = 0; n < table.force.size(); ++n) {
    most = std::max(most, std::abs(table.stencil[n]));
    difference = std::max(difference, std::abs(table.force[n] - table.stencil[n]));
  }
  if (difference <= 1e-14 * most) table.force = AlignedVector();
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
  const double R = options.kernel.support * options.smoothing_length;
  std::vector<Ghost<d>> ghosts = ghosts_behind(cloud, options.walls, R);
  const std::optional<Cloud<d>> extended =
      ghosts.empty() ? std::nullopt : std::optional(with_ghosts(cloud, ghosts));
  const Cloud<d>& all = extended ? *extended : cloud;
  const Surroundings<d> seen{all, table.slots, std::move(ghosts), find_neighbours<d>(all, R)};

  Kinds neighbourhoods = options.project ? all_different(cloud.size()) : kinds_by_neighbourhood(seen);
  auto bonds = bonds_of_kinds<d>(seen, neighbourhoods, options);
  if (options.project) {
    options.project(cloud, seen.all, bonds);
    neighbourhoods = kinds_by_stencil<d>(seen, bonds);
    std::vector<std::vector<BondConstants<d>>> shared;
    for (const Index i : neighbourhoods.representative) shared.push_back(std::move(bonds[i]));
    bonds = std::move(shared);
  }
  const Kinds kinds =
      options.adjust_force ? all_different(cloud.size()) : kinds_by_neighbours(seen, neighbourhoods);
  std::vector<SlotRow<d>> rows(kinds.representative.size());
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < static_cast<Index>(rows.size()); ++k) {
    const Index i = kinds.representative[k];
    rows[k] = slot_row<d>(i, seen, neighbourhoods, bonds, options);
    if (options.adjust_force) adjust<d>(rows[k], i, seen, options);
  }
  pack(table, rows, rows_of_slots(seen, kinds, table), options);
  if (options.project && !options.adjust_force) share_vectors(table);
  shrink_to_fit(table.begin, table.offset, table.separation, table.stencil, table.force, table.identity,
                table.own_force, table.laplacian, table.outer_laplacian, table.own_outer);
  if (table.mirror) {
    MirrorBonds<d>& m = *table.mirror;
    shrink_to_fit(m.begin, m.offset, m.signs, m.stencil, m.force, m.own_force, m.laplacian,
                  m.outer_laplacian);
  }
  return table;
}

template struct BondTable<1>;
template struct BondTable<2>;
template struct BondTable<3>;
template BondTable<1> make_bond_table<1>(Cloud<1>&, const BondOptions<1>&);
template BondTable<2> make_bond_table<2>(Cloud<2>&, const BondOptions<2>&);
template BondTable<3> make_bond_table<3>(Cloud<3>&, const BondOptions<3>&);

}  // namespace plumb
