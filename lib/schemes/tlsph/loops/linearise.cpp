#include "lib/schemes/tlsph/loops/linearise.hpp"

#include <algorithm>
#include <utility>

#include "lib/schemes/tlsph/bonds/each_bond.hpp"

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

/// What one particle has to do with another: a d x d table of numbers.
template <int d>
struct Share {
  Index other;
  int number;  ///< in the order in which they were found
  Mat<d> table;
};
template <int d>
using Shares = std::vector<Share<d>>;

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

/// A matrix that is filled row by row: row_of(i, shares) gives what particle i has to do with others, and append(rows, i, shares)
/// puts it there. Large clouds have no room for a list of all entries beside it.
template <int d, class RowOf, class Append>
SparseMatrix filled(Index particles, Index rows, Index columns, RowOf&& row_of, Append&& append) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> m(rows, columns);
  Shares<d> shares;
  for (Index i = 0; i < particles; ++i) {
    shares.clear();
    row_of(i, shares);
    tidy<d>(shares);
    if (i == 0) m.reserve(static_cast<Index>(shares.size()) * d * d * particles);
    append(m, i, shares);
  }
  m.finalize();
  return m;
}

/// G: displacements to deformation gradients, rows d^2 particle + d a + b.
template <int d>
SparseMatrix gradient_operator(const Solid<d>& solid, const std::vector<Index>& particle) {
  const auto row_of = [&](Index i, Shares<d>& shares) {
    Vec<d> sum = Vec<d>::Zero();
    const auto put = [&](Index j, const Vec<d>& c, const Vec<d>& signs = Vec<d>::Ones()) {
      add<d>(shares, j, signs * c.transpose());
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
  };
  const auto append = [](auto& m, Index i, const Shares<d>& shares) {
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) {
        m.startVec(d * d * i + d * a + b);
        for (const Share<d>& s : shares) m.insertBack(d * d * i + d * a + b, d * s.other + a) = s.table(a, b);
      }
  };
  const Index n = solid.cloud.size();
  return filled<d>(n, d * d * n, d * n, row_of, append);
}

/// -V D: first Piola-Kirchhoff stresses to minus the force on each particle.
template <int d>
SparseMatrix force_operator(const Solid<d>& solid, const std::vector<Index>& particle) {
  const BondTable<d>& t = solid.bonds;
  const auto row_of = [&](Index i, Shares<d>& shares) {
    const Index slot = t.slots.of(i), row = t.row[slot / t.width], lane = slot % t.width;
    const auto put = [&](Index j, const Vec<d>& weight, const Vec<d>& signs = Vec<d>::Ones()) {
      add<d>(shares, j, -solid.cloud.V[i] * signs * signs.cwiseProduct(weight).transpose());
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
  };
  const auto append = [](auto& m, Index i, const Shares<d>& shares) {
    for (int a = 0; a < d; ++a) {
      m.startVec(d * i + a);
      for (const Share<d>& s : shares)
        for (int b = 0; b < d; ++b) m.insertBack(d * i + a, d * d * s.other + d * a + b) = s.table(a, b);
    }
  };
  const Index n = solid.cloud.size();
  return filled<d>(n, d * n, d * d * n, row_of, append);
}

/// Sums of entries row by row. A row is put in order whenever it has doubled, so that the list never is much longer than the
/// matrix; what meets in one place is added in the order in which it came.
class RowSums {
 public:
  explicit RowSums(Index rows)
      : rows_(static_cast<std::size_t>(rows)), in_order_(static_cast<std::size_t>(rows), 0) {}

  void add(Index row, Index column, double value) {
    auto& entries = rows_[static_cast<std::size_t>(row)];
    entries.emplace_back(static_cast<SparseMatrix::StorageIndex>(column), value);
    if (entries.size() > 2 * in_order_[static_cast<std::size_t>(row)] + 64) put_in_order(row);
  }

  SparseMatrix matrix() {
    const auto count = static_cast<Index>(rows_.size());
    Index entries = 0;
    for (Index row = 0; row < count; ++row) {
      put_in_order(row);
      entries += static_cast<Index>(rows_[static_cast<std::size_t>(row)].size());
    }
    Eigen::SparseMatrix<double, Eigen::RowMajor> m(count, count);
    m.reserve(entries);
    for (Index row = 0; row < count; ++row) {
      m.startVec(row);
      for (const auto& [column, value] : rows_[static_cast<std::size_t>(row)])
        m.insertBack(row, column) = value;
      std::vector<Entry>().swap(rows_[static_cast<std::size_t>(row)]);
    }
    m.finalize();
    return m;
  }

 private:
  using Entry = std::pair<SparseMatrix::StorageIndex, double>;

  void put_in_order(Index row) {
    auto& entries = rows_[static_cast<std::size_t>(row)];
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.first < b.first; });
    std::size_t end = 0;
    for (const Entry& entry : entries) {
      if (end > 0 && entries[end - 1].first == entry.first)
        entries[end - 1].second += entry.second;
      else
        entries[end++] = entry;
    }
    entries.resize(end);
    in_order_[static_cast<std::size_t>(row)] = end;
  }

  std::vector<std::vector<Entry>> rows_;
  std::vector<std::size_t> in_order_;
};

}  // namespace

SparseMatrix per_component(const SparseMatrix& between_particles, int components) {
  SparseMatrix all(components * between_particles.rows(), components * between_particles.cols());
  all.reserve(components * between_particles.nonZeros());
  for (Index c = 0; c < between_particles.cols(); ++c)
    for (int k = 0; k < components; ++k) {
      all.startVec(components * c + k);
      for (SparseMatrix::InnerIterator it(between_particles, c); it; ++it)
        all.insertBack(components * it.row() + k, components * c + k) = it.value();
    }
  all.finalize();
  return all;
}

template <int d>
LinearOperators linear_operators(const Solid<d>& solid) {
  const std::vector<Index> particle = particle_of_slot(solid);
  LinearOperators operators;
  operators.gradient = gradient_operator(solid, particle);
  operators.force = force_operator(solid, particle);
  RowSums terms(solid.cloud.size());
  for (const auto& term : solid.terms)
    if (term.stiffness)
      term.stiffness(solid, [&](Index i, Index j, double value) { terms.add(i, j, value); });
  operators.terms = terms.matrix();
  operators.identity.resize(d * d * solid.cloud.size());
  Mat<d> identity = Mat<d>::Zero();
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Mat<d> found = estimated_identity(solid.bonds, solid.bonds.slots.of(i));
    // round-off of the table must not make a tangent per particle
    if ((found - identity).cwiseAbs().maxCoeff() > 1e-12) identity = found;
    for (int n = 0; n < d * d; ++n) operators.identity[d * d * i + n] = identity(n / d, n % d);
  }
  return operators;
}

template <int d>
SparseMatrix tangent_operator(const Solid<d>& solid, const Eigen::VectorXd& gradients) {
  const Index n = solid.cloud.size();
  std::vector<Tangent<d>> tangents(static_cast<std::size_t>(n));
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    Mat<d> F;
    for (int m = 0; m < d * d; ++m) F(m / d, m % d) = gradients[d * d * i + m];
    tangents[static_cast<std::size_t>(i)] = solid.sweeps.tangent(F);
  }
  Triplets entries;
  entries.reserve(tangents.size() * d * d * d * d);
  for (Index i = 0; i < n; ++i)
    for (int m = 0; m < d * d; ++m)
      for (int k = 0; k < d * d; ++k)
        entries.emplace_back(d * d * i + m, d * d * i + k, tangents[static_cast<std::size_t>(i)](m, k));
  return built<d>(d * d * n, d * d * n, entries);
}

template <int d>
Linearised linearise(const Solid<d>& solid) {
  const LinearOperators operators = linear_operators(solid);
  Linearised result;
  const SparseMatrix stress = tangent_operator(solid, operators.identity) * operators.gradient;
  result.stiffness = operators.force * stress;
  if (operators.terms.nonZeros() > 0) result.stiffness += per_component(operators.terms, d);
  result.mass = masses_of(solid);
  return result;
}

template <int d>
Eigen::VectorXd unknowns_of(const Solid<d>& solid, const Field& field) {
  Eigen::VectorXd values(d * solid.cloud.size());
  for (Index i = 0; i < solid.cloud.size(); ++i)
    values.segment<d>(d * i) = vector_at<d>(field, solid.bonds.slots.of(i));
  return values;
}

template <int d>
void set_unknowns(const Solid<d>& solid, const Eigen::VectorXd& values, Field& field) {
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(field, solid.bonds.slots.of(i), Vec<d>(values.segment<d>(d * i)));
}

template <int d>
Eigen::VectorXd masses_of(const Solid<d>& solid) {
  Eigen::VectorXd mass(d * solid.cloud.size());
  for (Index i = 0; i < solid.cloud.size(); ++i)
    mass.segment<d>(d * i).setConstant(solid.elastic.density * solid.cloud.V[i]);
  return mass;
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

#define PLUMBLINE_INSTANTIATE(d)                                                      \
  template LinearOperators linear_operators<d>(const Solid<d>&);                      \
  template SparseMatrix tangent_operator<d>(const Solid<d>&, const Eigen::VectorXd&); \
  template Linearised linearise<d>(const Solid<d>&);                                  \
  template Eigen::VectorXd unknowns_of<d>(const Solid<d>&, const Field&);             \
  template void set_unknowns<d>(const Solid<d>&, const Eigen::VectorXd&, Field&);     \
  template Eigen::VectorXd masses_of<d>(const Solid<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
