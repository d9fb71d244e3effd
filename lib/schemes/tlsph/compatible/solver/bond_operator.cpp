#include "lib/schemes/tlsph/compatible/solver/bond_operator.hpp"

#include <Eigen/Eigenvalues>

#include "lib/schemes/tlsph/compatible/solver/lane_vector.hpp"

namespace plumb {
namespace {

/// Inverse of a symmetric matrix; where it has none (bonds that lie in one plane), of the rest.
template <int n>
Eigen::Matrix<double, n, n> pseudo_inverse(const Eigen::Matrix<double, n, n>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> eigen(matrix);
  Eigen::Matrix<double, n, n> inverse = Eigen::Matrix<double, n, n>::Zero();
  for (int k = 0; k < n; ++k) {
    const auto& vector = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()[k] > 1e-13 * eigen.eigenvalues()[n - 1])  // less is the rounding of the largest
      inverse += vector * vector.transpose() / eigen.eigenvalues()[k];
  }
  return inverse;
}

template <int d>
typename BondOperator<d>::Row moments(const Vec<d>& half) {
  typename BondOperator<d>::Row p;
  p[0] = 1;
  p.template tail<d>() = half;
  return p;
}

}  // namespace

template <int d>
BondOperator<d> bond_operator(const AreaTable<d>& table, const std::vector<Vec<d>>& X, double volume_weight) {
  const Index n = table.particles();
  BondOperator<d> N;
  N.volume_weight = volume_weight;
  N.begin.assign(n + 1, 0);
  for (const auto& pair : table.pairs) {
    ++N.begin[pair.i + 1];
    ++N.begin[pair.j + 1];
  }
  for (Index i = 0; i < n; ++i) {
    N.begin[i + 1] += N.begin[i];
    N.X.push_back(X[i] / table.spacing);
  }
  N.other.resize(2 * table.pairs.size());
  N.weight.resize(2 * table.pairs.size());
  for (const auto& pair : table.pairs) {
    const Index at_i = N.begin[pair.i] + pair.place_i, at_j = N.begin[pair.j] + pair.place_j;
    N.other[at_i] = pair.j;
    N.other[at_j] = pair.i;
    N.weight[at_i] = N.weight[at_j] = pair.weight;
  }
  N.inverse_diagonal.resize(n);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    typename BondOperator<d>::Square diagonal = BondOperator<d>::Square::Zero();
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) {
      const auto p = moments<d>(N.half(i, b));
      diagonal += N.weight[b] * p * p.transpose();
    }
    N.inverse_diagonal[i] = pseudo_inverse<d + 1>(diagonal);
  }
  return N;
}

template <int d>
double trace(const MultiplierBlock<d>& x) {
  double sum = x(0, 1);
  for (int a = 1; a < d; ++a) sum += x(a, 1 + a);
  return sum;
}

template <int d>
void apply_bonds(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result) {
  using Lanes = LaneVector<double, lanes<d>>;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < N.particles(); ++i) {
    const auto column = [&](Index j, int k) { return load_lanes<Lanes>(x[j].data() + k * lanes<d>); };
    Lanes own[d + 1], sum[d + 1];
    for (int k = 0; k <= d; ++k) {
      own[k] = column(i, k);
      sum[k] = Lanes{};
    }
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) {
      const Index j = N.other[b];
      Lanes t = own[0] - column(j, 0);
      double half[d];
      for (int k = 0; k < d; ++k) {
        half[k] = 0.5 * (N.X[j][k] - N.X[i][k]);
        t += half[k] * (own[1 + k] + column(j, 1 + k));
      }
      t *= N.weight[b];
      sum[0] += t;
      for (int k = 0; k < d; ++k) sum[1 + k] += half[k] * t;
    }
    for (int k = 0; k <= d; ++k) store_lanes(sum[k], result[i].data() + k * lanes<d>);
  }
}

template <int d>
void apply(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result) {
  apply_bonds(N, x, result);
  if (N.volume_weight == 0) return;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < N.particles(); ++i) {
    const double answer = N.volume_weight * trace<d>(x[i]);
    for (int a = 0; a < d; ++a) result[i](a, 1 + a) += answer;
  }
}

#define PLUMB_INSTANTIATE(d)                                                                          \
  template BondOperator<d> bond_operator<d>(const AreaTable<d>&, const std::vector<Vec<d>>&, double); \
  template double trace<d>(const MultiplierBlock<d>&);                                                \
  template void apply_bonds<d>(const BondOperator<d>&, const Multipliers<d>&, Multipliers<d>&);       \
  template void apply<d>(const BondOperator<d>&, const Multipliers<d>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
