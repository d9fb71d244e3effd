#include "lib/schemes/tlsph/compatible/solver/constraints.hpp"

#include <algorithm>

namespace plumb {
namespace {

template <int d>
using Row = Eigen::Matrix<double, d + 1, 1>;

/// Derivatives of a particle's constraints with respect to A_ij: of i (sign +1) or of j (sign -1).
template <int d>
Row<d> derivative(const AreaVector<d>& pair, double sign) {
  Row<d> p;
  p[0] = sign;
  p.template tail<d>() = pair.X / 2;
  return p;
}

using Entries = std::vector<Eigen::Triplet<double>>;

}  // namespace

template <int d>
Multipliers<d> missing(const AreaTable<d>& table) {
  Multipliers<d> values(table.volume.size(), MultiplierBlock<d>::Zero());
  for (Index i = 0; i < table.particles(); ++i) {
    values[i].col(0).template head<d>() = -table.boundary[i];
    for (int a = 0; a < d; ++a) values[i](a, 1 + a) = table.volume[i];
  }
  for (const auto& pair : table.pairs) {
    values[pair.i].template topRows<d>() -= pair.A * derivative(pair, 1).transpose();
    values[pair.j].template topRows<d>() -= pair.A * derivative(pair, -1).transpose();
  }
  return values;
}

template <int d>
Vec<d> image(const AreaVector<d>& pair, const Multipliers<d>& x) {
  return pair.weight * (x[pair.i].template topRows<d>() * derivative(pair, 1) +
                        x[pair.j].template topRows<d>() * derivative(pair, -1));
}

template <int d>
void add_multipliers(AreaTable<d>& table, const BondOperator<d>& N, const Multipliers<d>& x) {
  for (auto& pair : table.pairs) pair.A += image(pair, x);
  if (N.volume_weight == 0) return;
  for (Index i = 0; i < table.particles(); ++i) table.volume[i] -= N.volume_weight * trace<d>(x[i]);
}

template <int d>
Eigen::SparseMatrix<double> normal_matrix(const AreaTable<d>& table, const BondOperator<d>& N) {
  constexpr int n = d + 1;
  const bool coupled = N.volume_weight > 0;
  const int parts = coupled ? d : 1;  // NOLINT(bugprone-branch-clone): alike in 1D only
  const int rows = parts * n;
  Entries entries;
  const auto add = [&](Index i, Index j, const Row<d>& p, const Row<d>& q, double weight) {
    if (i < j) return;
    for (int c = 0; c < parts; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
          if (i > j || a >= b)
            entries.emplace_back(i * rows + c * n + a, j * rows + c * n + b, weight * p[a] * q[b]);
  };
  for (const auto& pair : table.pairs) {
    const Row<d> p = derivative(pair, 1), q = derivative(pair, -1);
    add(pair.i, pair.i, p, p, pair.weight);
    add(pair.j, pair.j, q, q, pair.weight);
    add(pair.j, pair.i, q, p, pair.weight);
  }
  for (Index i = 0; coupled && i < table.particles(); ++i)  // volumes join L_11, L_22, ..
    for (int c = 0; c < d; ++c)
      for (int e = c; e < d; ++e)
        entries.emplace_back(i * rows + e * n + 1 + e, i * rows + c * n + 1 + c, N.volume_weight);
  Eigen::SparseMatrix<double> matrix(rows * table.particles(), rows * table.particles());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <int d>
double largest(const Multipliers<d>& values) {
  double most = 0;
  for (const auto& block : values) {
    const double here = block.cwiseAbs().maxCoeff();
    if (!(here <= most)) most = here;  // NaN comes through
  }
  return most;
}

#define PLUMB_INSTANTIATE(d)                                                                          \
  template Multipliers<d> missing<d>(const AreaTable<d>&);                                            \
  template Vec<d> image<d>(const AreaVector<d>&, const Multipliers<d>&);                              \
  template void add_multipliers<d>(AreaTable<d>&, const BondOperator<d>&, const Multipliers<d>&);     \
  template Eigen::SparseMatrix<double> normal_matrix<d>(const AreaTable<d>&, const BondOperator<d>&); \
  template double largest<d>(const Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
