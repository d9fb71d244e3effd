#include "lib/schemes/tlsph/compatible/solver/quadratic_fields.hpp"

#include <algorithm>

#include "lib/linear/dense.hpp"

namespace plumb {

template <int d>
typename QuadraticFields<d>::Values QuadraticFields<d>::at(const Vec<d>& X) const {
  Values q = Values::Zero();
  const Vec<d> x = (X - centre) / radius;
  int field = 0;
  q(0, field++) = 1;
  for (int a = 0; a < d; ++a, ++field) {
    q(0, field) = x[a];
    q(1 + a, field) = 1 / radius;
  }
  for (int a = 0; a < d; ++a)
    for (int b = a; b < d; ++b, ++field) {
      q(0, field) = x[a] * x[b];
      q(1 + a, field) += x[b] / radius;
      q(1 + b, field) += x[a] / radius;
    }
  return q;
}

namespace {

/// Products of all fields with each other, and with the normal matrix between them.
template <int d>
struct Products {
  Eigen::MatrixXd gram, matrix;
};
template <int d>
Products<d> products(const QuadraticFields<d>& fields, const BondOperator<d>& N) {
  constexpr int m = QuadraticFields<d>::scalars, size = QuadraticFields<d>::size;
  Products<d> p{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size)};
  Eigen::Matrix<double, m, m> gram = Eigen::Matrix<double, m, m>::Zero();
  Eigen::Matrix<double, size, 1> divergence;
  for (const auto& X : N.X) {
    const auto q = fields.at(X);
    gram += q.transpose() * q;
    for (int a = 0; a < d; ++a) divergence.template segment<m>(a * m) = q.row(1 + a).transpose();
    p.matrix += N.volume_weight * divergence * divergence.transpose();
  }
  for (int a = 0; a < d; ++a) p.gram.template block<m, m>(a * m, a * m) = gram;
  return p;
}

/// Columns that are orthonormal in this product: fields that the particles do not tell apart are left out.
Eigen::MatrixXd orthonormal_in(const Eigen::MatrixXd& gram) {
  const SymmetricPairs eigen = symmetric_pairs(gram);
  const double least = 1e-13 * eigen.values[gram.rows() - 1];
  Eigen::Index first = 0;
  while (eigen.values[first] <= least) ++first;
  const Eigen::Index count = gram.rows() - first;
  return eigen.vectors.rightCols(count) * eigen.values.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

template <int d>
QuadraticFields<d> quadratic_fields(const BondOperator<d>& N) {
  QuadraticFields<d> fields{Vec<d>::Zero(), 0, {}};
  for (const auto& x : N.X) fields.centre += x / static_cast<double>(N.X.size());
  for (const auto& x : N.X) fields.radius = std::max(fields.radius, (x - fields.centre).norm());
  const auto [gram, matrix] = products(fields, N);
  const Eigen::MatrixXd basis = orthonormal_in(gram);
  const SymmetricPairs eigen = symmetric_pairs(basis.transpose() * matrix * basis);
  const Eigen::MatrixXd vectors = basis * eigen.vectors;
  fields.along_null = Eigen::MatrixXd::Zero(gram.rows(), gram.rows());
  for (Eigen::Index k = 0; k < vectors.cols(); ++k)
    // the others are of the order of the largest: |div q|^2 of fields of one size
    if (!(eigen.values[k] > 1e-10 * eigen.values.maxCoeff()))
      fields.along_null += vectors.col(k) * vectors.col(k).transpose();
  return fields;
}

template <int d>
void remove_null_part(const QuadraticFields<d>& fields, const std::vector<Vec<d>>& X, Multipliers<d>& r) {
  constexpr int m = QuadraticFields<d>::scalars;
  Eigen::Matrix<double, m, d> part = Eigen::Matrix<double, m, d>::Zero();
  for (std::size_t i = 0; i < X.size(); ++i)
    part += fields.at(X[i]).transpose() * r[i].template topRows<d>().transpose();
  const Eigen::VectorXd c = fields.along_null * Eigen::Map<const Eigen::VectorXd>(part.data(), part.size());
  part = Eigen::Map<const Eigen::Matrix<double, m, d>>(c.data());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i)
    r[i].template topRows<d>() -= (fields.at(X[i]) * part).transpose();
}

#define PLUMB_INSTANTIATE(d)                                               \
  template struct QuadraticFields<d>;                                      \
  template QuadraticFields<d> quadratic_fields<d>(const BondOperator<d>&); \
  template void remove_null_part<d>(const QuadraticFields<d>&, const std::vector<Vec<d>>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
