#include "plumbline/solid/linearise.hpp"

#include <algorithm>

namespace plumb {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

template <int d>
std::vector<Index> particle_of_slot(const Solid<d>& solid) {
  std::vector<Index> particle(solid.bonds.slots.count(), -1);
  for (Index i = 0; i < solid.cloud.size(); ++i) particle[solid.bonds.slots.of(i)] = i;
  return particle;
}

/// Calls use(j, constants of the bond) for every bond of the particle in this slot; `table` has d doubles per
/// bond and lane.
template <int d, class Use>
void for_each_bond(const BondTable<d>& t, const AlignedVector& table, Index slot, Use&& use) {
  const Index row = t.row[slot / t.width], lane = slot % t.width;
  for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n) {
    Vec<d> X, c;
    for (int k = 0; k < d; ++k) {
      X[k] = t.separation[(n * d + k) * t.width + lane];
      c[k] = table[(n * d + k) * t.width + lane];
    }
    if (X.squaredNorm() > 0) use(slot + t.offset[n], c);
  }
}

/// The same for bonds to images: use(j, signs of the reflection, constants).
template <int d, class Use>
void for_each_image(const BondTable<d>& t, AlignedVector MirrorBonds<d>::*table, Index slot, Use&& use) {
  if (!t.mirror) return;
  const MirrorBonds<d>& m = *t.mirror;
  const Index row = t.row[slot / t.width], lane = slot % t.width;
  for (std::int64_t n = m.begin[row]; n < m.begin[row + 1]; ++n) {
    Vec<d> c;
    for (int k = 0; k < d; ++k) c[k] = (m.*table)[(n * d + k) * t.width + lane];
    if (c.squaredNorm() > 0) use(slot + m.offset[n], m.signs[n], c);
  }
}

template <int d>
SparseMatrix built(Index rows, Index columns, const Triplets& entries) {
  SparseMatrix m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

/// G: displacements to deformation gradients, rows d^2 particle + d a + b.
template <int d>
SparseMatrix gradient_operator(const Solid<d>& solid, const std::vector<Index>& particle) {
  Triplets entries;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    Vec<d> sum = Vec<d>::Zero();
    const auto put = [&](Index j, const Vec<d>& c, const Vec<d>& signs = Vec<d>::Ones()) {
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) entries.emplace_back(d * d * i + d * a + b, d * j + a, signs[a] * c[b]);
      sum += c;
    };
    const Index own = solid.bonds.slots.of(i);
    for_each_bond<d>(solid.bonds, solid.bonds.stencil, own,
                     [&](Index slot, const Vec<d>& c) { put(particle[slot], c); });
    for_each_image<d>(
        solid.bonds, &MirrorBonds<d>::stencil, own,
        [&](Index slot, const Vec<d>& signs, const Vec<d>& c) { put(particle[slot], c, signs); });
    put(i, -sum);
  }
  return built<d>(d * d * solid.cloud.size(), d * solid.cloud.size(), entries);
}

/// T: one material tangent per particle, at the gradient that it has in the reference state (I for every
/// consistent estimator).
template <int d>
SparseMatrix tangent_operator(const Solid<d>& solid) {
  const BondTable<d>& t = solid.bonds;
  Triplets entries;
  Mat<d> F_last = Mat<d>::Zero();
  Tangent<d> tangent;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Index slot = t.slots.of(i), row = t.row[slot / t.width], lane = slot % t.width;
    Mat<d> F;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) F(a, b) = t.identity[((row * d + a) * d + b) * t.width + lane];
    // round-off of the table must not make a tangent per particle
    if ((F - F_last).cwiseAbs().maxCoeff() > 1e-12) tangent = solid.sweeps.tangent(F_last = F);
    for (int m = 0; m < d * d; ++m)
      for (int n = 0; n < d * d; ++n) entries.emplace_back(d * d * i + m, d * d * i + n, tangent(m, n));
  }
  return built<d>(d * d * solid.cloud.size(), d * d * solid.cloud.size(), entries);
}

/// -V D: first Piola-Kirchhoff stresses to minus the force on each particle.
template <int d>
SparseMatrix force_operator(const Solid<d>& solid, const std::vector<Index>& particle) {
  const BondTable<d>& t = solid.bonds;
  Triplets entries;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Index slot = t.slots.of(i), row = t.row[slot / t.width], lane = slot % t.width;
    const auto put = [&](Index j, const Vec<d>& weight, const Vec<d>& signs = Vec<d>::Ones()) {
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b)
          entries.emplace_back(d * i + a, d * d * j + d * a + b,
                               -solid.cloud.V[i] * signs[a] * signs[b] * weight[b]);
    };
    Vec<d> own;
    for (int k = 0; k < d; ++k) own[k] = t.own_force[(row * d + k) * t.width + lane];
    if (t.mirror)
      for (int k = 0; k < d; ++k) own[k] += t.mirror->own_force[(row * d + k) * t.width + lane];
    put(i, own);
    for_each_bond<d>(t, t.force_weights(), slot,
                     [&](Index other, const Vec<d>& a) { put(particle[other], a); });
    for_each_image<d>(
        t, &MirrorBonds<d>::force, slot,
        [&](Index other, const Vec<d>& signs, const Vec<d>& a) { put(particle[other], a, signs); });
  }
  return built<d>(d * solid.cloud.size(), d * d * solid.cloud.size(), entries);
}

}  // namespace

template <int d>
Linearised linearise(const Solid<d>& solid) {
  const std::vector<Index> particle = particle_of_slot(solid);
  Linearised result;
  const SparseMatrix stress = tangent_operator(solid) * gradient_operator(solid, particle);
  result.stiffness = force_operator(solid, particle) * stress;
  std::vector<StiffnessEntry> extra;
  for (const auto& term : solid.terms)
    if (term.stiffness) term.stiffness(solid, extra);
  if (!extra.empty()) {
    Triplets entries;
    for (const auto& e : extra) entries.emplace_back(e.row, e.column, e.value);
    result.stiffness += built<d>(result.stiffness.rows(), result.stiffness.cols(), entries);
  }
  result.mass.resize(d * solid.cloud.size());
  for (Index i = 0; i < solid.cloud.size(); ++i)
    result.mass.segment<d>(d * i).setConstant(solid.elastic.density * solid.cloud.V[i]);
  return result;
}

std::vector<Index> free_unknowns(Index unknowns, const std::vector<Index>& held) {
  std::vector<bool> is_held(unknowns, false);
  for (const Index n : held) is_held[n] = true;
  std::vector<Index> free;
  for (Index n = 0; n < unknowns; ++n)
    if (!is_held[n]) free.push_back(n);
  return free;
}

SparseMatrix part_of(const SparseMatrix& matrix, const std::vector<Index>& rows,
                     const std::vector<Index>& columns) {
  std::vector<Index> number(matrix.rows(), -1);
  for (std::size_t n = 0; n < rows.size(); ++n) number[rows[n]] = static_cast<Index>(n);
  Triplets entries;
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (SparseMatrix::InnerIterator it(matrix, columns[c]); it; ++it)
      if (number[it.row()] >= 0) entries.emplace_back(number[it.row()], static_cast<Index>(c), it.value());
  SparseMatrix part(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

template Linearised linearise<1>(const Solid<1>&);
template Linearised linearise<2>(const Solid<2>&);
template Linearised linearise<3>(const Solid<3>&);

}  // namespace plumb
