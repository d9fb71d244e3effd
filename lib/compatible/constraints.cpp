#include "plumbline/compatible/constraints.hpp"

namespace plumb {
namespace {

template <int d>
using Row = Eigen::Matrix<double, d + 1, 1>;
template <int d>
using Square = Eigen::Matrix<double, d + 1, d + 1>;

/// Derivatives of a particle's constraints with respect to A_ij: of i (sign +1) or of j (sign -1).
template <int d>
Row<d> derivative(const AreaVector<d>& pair, double sign) {
  Row<d> p;
  p[0] = sign;
  p.template tail<d>() = pair.X / 2;
  return p;
}

/// The structure of the lower triangle: for each particle the partners j >= i, ascending, itself first.
template <int d>
std::vector<std::vector<std::int32_t>> partners(const AreaTable<d>& table) {
  std::vector<std::vector<std::int32_t>> of(table.volume.size());
  for (std::size_t i = 0; i < of.size(); ++i) of[i].push_back(static_cast<std::int32_t>(i));
  for (const auto& pair : table.pairs) of[pair.i].push_back(pair.j);
  return of;
}

}  // namespace

template <int d>
ConstraintValues missing(const AreaTable<d>& table) {
  ConstraintValues values = ConstraintValues::Zero((d + 1) * table.particles(), d);
  for (Index i = 0; i < table.particles(); ++i) {
    values.row((d + 1) * i) = -table.boundary[i].transpose();
    for (int a = 0; a < d; ++a) values((d + 1) * i + 1 + a, a) = table.volume[i];
  }
  for (const auto& pair : table.pairs) {
    values.template middleRows<d + 1>((d + 1) * pair.i) -= derivative(pair, 1) * pair.A.transpose();
    values.template middleRows<d + 1>((d + 1) * pair.j) -= derivative(pair, -1) * pair.A.transpose();
  }
  return values;
}

template <int d>
void add_multipliers(AreaTable<d>& table, const ConstraintValues& multipliers, double volume_weight) {
  for (auto& pair : table.pairs)
    pair.A += pair.weight *
              (multipliers.template middleRows<d + 1>((d + 1) * pair.i).transpose() * derivative(pair, 1) +
               multipliers.template middleRows<d + 1>((d + 1) * pair.j).transpose() * derivative(pair, -1));
  if (volume_weight == 0) return;
  for (Index i = 0; i < table.particles(); ++i)
    table.volume[i] -= volume_weight * multipliers.template middleRows<d>((d + 1) * i + 1).trace();
}

template <int d>
Eigen::SparseMatrix<double> normal_matrix(const AreaTable<d>& table, double volume_weight) {
  constexpr int n = d + 1;
  const int parts = volume_weight > 0 ? d : 1, rows = parts * n;
  const auto columns = partners(table);
  std::vector<Square<d>> own(table.volume.size(), Square<d>::Zero()), other(table.pairs.size());
  std::vector<std::size_t> first(table.volume.size(), 0);  // pairs are sorted by i
  for (std::size_t k = table.pairs.size(); k-- > 0;) {
    const auto& pair = table.pairs[k];
    const Row<d> p = derivative(pair, 1), q = derivative(pair, -1);
    own[pair.i] += pair.weight * p * p.transpose();
    own[pair.j] += pair.weight * q * q.transpose();
    other[k] = pair.weight * q * p.transpose();  // row of j, column of i
    first[pair.i] = k;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve((own.size() + other.size()) * static_cast<std::size_t>(parts * n * n));
  for (std::size_t i = 0; i < own.size(); ++i)
    for (int c = 0; c < parts; ++c)
      for (int b = 0; b < n; ++b) {
        const auto column = static_cast<int>(i) * rows + c * n + b;
        for (std::size_t m = 0; m < columns[i].size(); ++m) {
          const Square<d>& block = m == 0 ? own[i] : other[first[i] + m - 1];
          for (int a = m == 0 ? b : 0; a < n; ++a)
            entries.emplace_back(columns[i][m] * rows + c * n + a, column, block(a, b));
        }
        if (volume_weight > 0 && b == 1 + c)  // volumes couple L_11, L_22, ..
          for (int e = c; e < d; ++e)
            entries.emplace_back(static_cast<int>(i) * rows + e * n + 1 + e, column, volume_weight);
      }
  Eigen::SparseMatrix<double> matrix(rows * table.particles(), rows * table.particles());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template ConstraintValues missing<1>(const AreaTable<1>&);
template ConstraintValues missing<2>(const AreaTable<2>&);
template ConstraintValues missing<3>(const AreaTable<3>&);
template void add_multipliers<1>(AreaTable<1>&, const ConstraintValues&, double);
template void add_multipliers<2>(AreaTable<2>&, const ConstraintValues&, double);
template void add_multipliers<3>(AreaTable<3>&, const ConstraintValues&, double);
template Eigen::SparseMatrix<double> normal_matrix<1>(const AreaTable<1>&, double);
template Eigen::SparseMatrix<double> normal_matrix<2>(const AreaTable<2>&, double);
template Eigen::SparseMatrix<double> normal_matrix<3>(const AreaTable<3>&, double);

}  // namespace plumb
