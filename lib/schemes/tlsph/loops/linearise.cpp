#include "lib/schemes/tlsph/loops/linearise.hpp"

#include <algorithm>
#include <utility>

#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/loops/operator_rows.hpp"

namespace plumb {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

template <int d>
SparseMatrix built(Index rows, Index columns, const Triplets& entries) {
  SparseMatrix m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

/// A matrix that is filled row by row: row_of(i, shares) gives what particle i has to do with others, and append(rows, i, shares)
/// puts it there. Large clouds have no room for a list of all entries beside it.
template <int d, class RowOf, class Append>
SparseMatrix filled(Index particles, Index rows, Index columns, RowOf&& row_of, Append&& append) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> m(rows, columns);
  Shares<d> shares;
  for (Index i = 0; i < particles; ++i) {
    row_of(i, shares);
    if (i == 0) m.reserve(static_cast<Index>(shares.size()) * d * d * particles);
    append(m, i, shares);
  }
  m.finalize();
  return m;
}

/// G: displacements to deformation gradients, rows d^2 particle + d a + b.
template <int d>
SparseMatrix gradient_operator(const OperatorRows<d>& rows, Index n) {
  const auto append = [](auto& m, Index i, const Shares<d>& shares) {
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) {
        m.startVec(d * d * i + d * a + b);
        for (const Share<d>& s : shares) m.insertBack(d * d * i + d * a + b, d * s.other + a) = s.table(a, b);
      }
  };
  return filled<d>(
      n, d * d * n, d * n, [&](Index i, Shares<d>& shares) { rows.gradient(i, shares); }, append);
}

/// -V D: first Piola-Kirchhoff stresses to minus the force on each particle.
template <int d>
SparseMatrix force_operator(const OperatorRows<d>& rows, Index n) {
  const auto append = [](auto& m, Index i, const Shares<d>& shares) {
    for (int a = 0; a < d; ++a) {
      m.startVec(d * i + a);
      for (const Share<d>& s : shares)
        for (int b = 0; b < d; ++b) m.insertBack(d * i + a, d * d * s.other + d * a + b) = s.table(a, b);
    }
  };
  return filled<d>(
      n, d * n, d * d * n, [&](Index i, Shares<d>& shares) { rows.force(i, shares); }, append);
}

/// Sums of entries column by column. A column is put in order whenever it has doubled, so that the list never is much longer than the
/// matrix; what meets in one place is added in the order in which it came.
class ColumnSums {
 public:
  explicit ColumnSums(Index columns)
      : columns_(static_cast<std::size_t>(columns)), in_order_(static_cast<std::size_t>(columns), 0) {}

  void add(Index row, Index column, double value) {
    auto& entries = columns_[static_cast<std::size_t>(column)];
    entries.emplace_back(static_cast<SparseMatrix::StorageIndex>(row), value);
    if (entries.size() > 2 * in_order_[static_cast<std::size_t>(column)] + 64) put_in_order(column);
  }

  /// Empties itself.
  SparseMatrix matrix() {
    const auto count = static_cast<Index>(columns_.size());
    Index entries = 0;
    for (Index column = 0; column < count; ++column) {
      put_in_order(column);
      entries += static_cast<Index>(columns_[static_cast<std::size_t>(column)].size());
    }
    SparseMatrix m(count, count);
    m.reserve(entries);
    for (Index column = 0; column < count; ++column) {
      m.startVec(column);
      for (const auto& [row, value] : columns_[static_cast<std::size_t>(column)])
        m.insertBack(row, column) = value;
      std::vector<Entry>().swap(columns_[static_cast<std::size_t>(column)]);
    }
    m.finalize();
    return m;
  }

 private:
  using Entry = std::pair<SparseMatrix::StorageIndex, double>;

  void put_in_order(Index column) {
    auto& entries = columns_[static_cast<std::size_t>(column)];
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
    in_order_[static_cast<std::size_t>(column)] = end;
  }

  std::vector<std::vector<Entry>> columns_;
  std::vector<std::size_t> in_order_;
};

/// The stiffness of these terms between particles, at the places that keep(row, column) chooses.
template <int d, class Keep>
SparseMatrix sum_of_terms(const Solid<d>& solid, const std::vector<Term<d>>& terms, Keep&& keep) {
  ColumnSums sums(solid.cloud.size());
  for (const auto& term : terms)
    if (term.stiffness)
      term.stiffness(solid, [&](Index i, Index j, double value) {
        if (keep(i, j)) sums.add(i, j, value);
      });
  return sums.matrix();
}

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
  const OperatorRows<d> rows(solid);
  LinearOperators operators;
  operators.gradient = gradient_operator(rows, solid.cloud.size());
  operators.force = force_operator(rows, solid.cloud.size());
  operators.terms = sum_of_terms(solid, solid.terms, [](Index, Index) { return true; });
  operators.identity = gradients_of_reference(solid);
  return operators;
}

template <int d>
SparseMatrix half_of_terms(const Solid<d>& solid, const std::vector<Term<d>>& terms) {
  return sum_of_terms(solid, terms, [](Index i, Index j) { return i >= j; });
}

template <int d>
Eigen::VectorXd gradients_of_reference(const Solid<d>& solid) {
  Eigen::VectorXd all(d * d * solid.cloud.size());
  Mat<d> identity = Mat<d>::Zero();
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Mat<d> found = estimated_identity(solid.bonds, solid.bonds.slots.of(i));
    // round-off of the table must not make a tangent per particle
    if ((found - identity).cwiseAbs().maxCoeff() > 1e-12) identity = found;
    for (int n = 0; n < d * d; ++n) all[d * d * i + n] = identity(n / d, n % d);
  }
  return all;
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

#define PLUMBLINE_INSTANTIATE(d)                                                        \
  template LinearOperators linear_operators<d>(const Solid<d>&);                        \
  template SparseMatrix half_of_terms<d>(const Solid<d>&, const std::vector<Term<d>>&); \
  template Eigen::VectorXd gradients_of_reference<d>(const Solid<d>&);                  \
  template SparseMatrix tangent_operator<d>(const Solid<d>&, const Eigen::VectorXd&);   \
  template Linearised linearise<d>(const Solid<d>&);                                    \
  template Eigen::VectorXd unknowns_of<d>(const Solid<d>&, const Field&);               \
  template void set_unknowns<d>(const Solid<d>&, const Eigen::VectorXd&, Field&);       \
  template Eigen::VectorXd masses_of<d>(const Solid<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
