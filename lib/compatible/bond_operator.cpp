#include "plumbline/compatible/bond_operator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

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

/// Rows of G: what a field differs by from the linear fit of its neighbours, weighted as the bonds are.
/// Scaled so that the absolute values of a row add up to 1.
template <int d>
void make_fits(BondOperator<d>& N) {
  const Index n = N.particles();
  N.fit.resize(n);
  N.own_fit.resize(n);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    const auto fit = N.inverse_diagonal[i].row(0).transpose().eval();
    double sum = 1;
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b)
      sum += std::abs(N.weight[b] * fit.dot(moments<d>(N.half(i, b))));
    N.fit[i] = fit / sum;
    N.own_fit[i] = 1 / sum;
  }
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
  if (volume_weight > 0) make_fits(N);
  return N;
}

template <int d>
std::vector<double> traces(const Multipliers<d>& x) {
  std::vector<double> trace(x.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {
    trace[i] = x[i](0, 1);
    for (int a = 1; a < d; ++a) trace[i] += x[i](a, 1 + a);
  }
  return trace;
}

template <int d>
std::vector<double> volume_answer(const BondOperator<d>& N, const std::vector<double>& trace) {
  const Index n = N.particles();
  std::vector<double> difference(n), answer(n);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    double sum = N.own_fit[i] * trace[i];
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) sum += fit_weight(N, i, b) * trace[N.other[b]];
    difference[i] = N.volume_weight * sum;
  }
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    double sum = N.own_fit[i] * difference[i];
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) {
      const Index j = N.other[b];
      const Vec<d> half = N.half(i, b);  // -half is that of j
      sum -= N.weight[b] * (N.fit[j][0] - N.fit[j].template tail<d>().dot(half)) * difference[j];
    }
    answer[i] = sum;
  }
  return answer;
}

template <int d>
void apply_bonds(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result) {
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < N.particles(); ++i) {
    const MultiplierBlock<d> own = x[i];
    MultiplierBlock<d> sum = MultiplierBlock<d>::Zero();
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b) {
      const MultiplierBlock<d>& far = x[N.other[b]];
      const Vec<d> half = N.half(i, b);
      Eigen::Matrix<double, lanes<d>, 1> t = own.col(0) - far.col(0);
      for (int k = 0; k < d; ++k) t += half[k] * (own.col(1 + k) + far.col(1 + k));
      t *= N.weight[b];
      sum.col(0) += t;
      for (int k = 0; k < d; ++k) sum.col(1 + k) += half[k] * t;
    }
    result[i] = sum;
  }
}

template <int d>
void apply(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result) {
  apply_bonds(N, x, result);
  if (N.volume_weight == 0) return;
  const std::vector<double> volumes = volume_answer(N, traces<d>(x));
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < N.particles(); ++i)
    for (int a = 0; a < d; ++a) result[i](a, 1 + a) += volumes[i];
}

#define PLUMB_INSTANTIATE(d)                                                                          \
  template BondOperator<d> bond_operator<d>(const AreaTable<d>&, const std::vector<Vec<d>>&, double); \
  template std::vector<double> traces<d>(const Multipliers<d>&);                                      \
  template std::vector<double> volume_answer<d>(const BondOperator<d>&, const std::vector<double>&);  \
  template void apply_bonds<d>(const BondOperator<d>&, const Multipliers<d>&, Multipliers<d>&);       \
  template void apply<d>(const BondOperator<d>&, const Multipliers<d>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
