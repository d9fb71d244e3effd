#include "plumbline/solid/linearise.hpp"

#include <algorithm>

#include "plumbline/gradient/each_bond.hpp"

namespace plumb {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

template <int d>
std::vector<Index> particle_of_slot(const Solid<d>& solid) {
  std::vector<Index> particle(solid.bonds.slots.count(), -1);
  for (Index i = 0; i < solid.cloud.size(); ++i) particle[solid.bonds.slots.of(i)] = i;
  return particle;
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
    for_each_bond(solid.bonds, own, [&](const BondEntry<d>& bond, const Vec<d>&) {
      put(particle[bond.other], bond.vector(solid.bonds.stencil));
    });
    for_each_image(solid.bonds, own, [&](const BondEntry<d>& bond, const Vec<d>& signs) {
      const Vec<d> c = bond.vector(solid.bonds.mirror->stencil);
      if (c.squaredNorm() > 0) put(particle[bond.other], c, signs);
    });
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
    const Mat<d> F = estimated_identity(t, t.slots.of(i));
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
    for_each_bond(t, slot, [&](const BondEntry<d>& bond, const Vec<d>&) {
      put(particle[bond.other], bond.vector(t.force_weights()));
    });
    for_each_image(t, slot, [&](const BondEntry<d>& bond, const Vec<d>& signs) {
      const Vec<d> a = bond.vector(t.mirror->force);
      if (a.squaredNorm() > 0) put(particle[bond.other], a, signs);
    });
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
