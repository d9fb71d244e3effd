#include "lib/schemes/mixed/mixed_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "lib/kernel/kernels/quadratic.hpp"
#include "lib/schemes/mixed/kernel_sums.hpp"
#include "lib/schemes/mixed/smoothing.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/bonds/estimator.hpp"
#include "lib/schemes/tlsph/bonds/forms/adjoint.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/compatible/lattice_closure.hpp"
#include "lib/schemes/upwind.hpp"

namespace plumb {
namespace {

/// Makes a table of the scheme's neighbour list with constants g_ab and the adjoint form.
template <int d>
BondTable<d> material_table(Cloud<d>& cloud, const MixedOptions& options,
                            const std::optional<Surface<d>>& surface, KernelSums& sums) {
  BondOptions<d> o;
  o.kernel = radial_kernel<d, Quadratic>();
  o.smoothing_length = options.list * cloud.spacing / Quadratic::support;
  o.momentum = {&Adjoint::other<d>, &Adjoint::own<d>};
  if (options.gradient == "compatible") {
    o.pair = Correction::W1;
    o.estimator = estimator_named<d>("improved");
    if (reason_against_closure<d>(cloud, options.list * cloud.spacing)) {
      CompatibleOptions<d> how;
      if (surface) how.surface = [surface](const Cloud<d>&) { return *surface; };
      project_compatible(o, how);
    } else {
      close_on_lattice<d>(o, cloud);
    }
    o.project = [&, inner = o.project](Cloud<d>& all, const Neighbours& list,
                                       std::vector<std::vector<BondConstants<d>>>& bonds) {
      sums = kernel_sums<d>(all, list, true);
      if (inner) inner(all, list, bonds);
    };
    return make_bond_table<d>(cloud, o);
  }
  o.pair = Correction::none;
  o.estimator = [](Neighbourhood<d> seen, const CorrectedKernel<d>&) {
    return std::vector<Vec<d>>(seen.size(), Vec<d>::Zero());  // they are made all together
  };
  o.project = [&](Cloud<d>& all, const Neighbours& list, std::vector<std::vector<BondConstants<d>>>& bonds) {
    sums = kernel_sums<d>(all, list, options.volumes == "equal");
    for (Index a = 0; a < all.size(); ++a) {
      const std::vector<Vec<d>> g = corrected_gradients<d>(all, list, sums, a);
      std::size_t n = 0, entry = 0;
      for (const auto b : list.of(a)) {
        if (b != a) bonds[a][n++].stencil = g[entry];
        ++entry;
      }
    }
  };
  return make_bond_table<d>(cloud, o);
}

/// The same table with a row for every pack.
template <int d>
BondTable<d> with_own_rows(const BondTable<d>& shared) {
  BondTable<d> t = shared;
  const Index W = t.width;
  t.begin.assign(1, 0);
  t.offset.clear();
  for (auto* values : {&t.separation, &t.stencil, &t.force, &t.identity, &t.own_force}) values->clear();
  for (Index pack = 0; pack < t.slots.packs(); ++pack) {
    const Index row = shared.row[pack];
    const std::int64_t first = shared.begin[row], end = shared.begin[row + 1];
    const auto append = [](auto& to, const auto& from, std::int64_t begin, std::int64_t stop) {
      to.insert(to.end(), from.begin() + begin, from.begin() + stop);
    };
    append(t.offset, shared.offset, first, end);
    append(t.separation, shared.separation, first * d * W, end * d * W);
    append(t.stencil, shared.stencil, first * d * W, end * d * W);
    append(t.force, shared.force_weights(), first * d * W, end * d * W);
    append(t.identity, shared.identity, row * d * d * W, (row + 1) * d * d * W);
    append(t.own_force, shared.own_force, row * d * W, (row + 1) * d * W);
    t.begin.push_back(static_cast<std::int64_t>(t.offset.size()));
    t.row[pack] = static_cast<std::int32_t>(pack);
  }
  return t;
}

template <int d>
std::vector<std::int64_t> reverse_places(const BondTable<d>& t) {
  std::vector<std::int64_t> reverse(t.offset.size() * static_cast<std::size_t>(t.width), -1);
  for (Index i = 0; i < t.slots.count(); ++i)
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>&) {
      const Index row = t.row[bond.other / t.width];
      const auto first = t.offset.begin() + t.begin[row], end = t.offset.begin() + t.begin[row + 1];
      const auto back = std::lower_bound(first, end, static_cast<std::int32_t>(i - bond.other));
      reverse[bond.place()] = (back - t.offset.begin()) * t.width + bond.other % t.width;
    });
  return reverse;
}

}  // namespace

template <int d>
MixedBonds<d> make_mixed_bonds(Cloud<d>& cloud, const MixedOptions& options, double density,
                               const std::optional<Surface<d>>& surface) {
  MixedBonds<d> bonds;
  KernelSums sums;
  bonds.table = material_table<d>(cloud, options, surface, sums);
  if (options.option > 0) {
    bonds.table = with_own_rows(bonds.table);
    bonds.reverse = reverse_places(bonds.table);
  }
  const BondTable<d>& t = bonds.table;
  bonds.inverse_h = Field(1, t.slots.count(), t.margin);
  bonds.volume = bonds.strength = bonds.inverse_h;
  for (Index p = 0; p < cloud.size(); ++p) {
    const Index slot = t.slots.of(p);
    bonds.inverse_h[0][slot] = 1 / sums.h[p];
    bonds.volume[0][slot] = sums.volume[p];
    bonds.strength[0][slot] = sums.volume[p] / std::pow(sums.h[p], d);
  }
  bonds.impedance = pair_impedance(t, density);
  if (options.smooth_positions) make_smoothing(bonds);
  return bonds;
}

template struct MixedBonds<1>;
template struct MixedBonds<2>;
template struct MixedBonds<3>;
template MixedBonds<1> make_mixed_bonds<1>(Cloud<1>&, const MixedOptions&, double,
                                           const std::optional<Surface<1>>&);
template MixedBonds<2> make_mixed_bonds<2>(Cloud<2>&, const MixedOptions&, double,
                                           const std::optional<Surface<2>>&);
template MixedBonds<3> make_mixed_bonds<3>(Cloud<3>&, const MixedOptions&, double,
                                           const std::optional<Surface<3>>&);

}  // namespace plumb
