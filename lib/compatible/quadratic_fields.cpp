#include "plumbline/compatible/quadratic_fields.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

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

template <int d>
QuadraticFields<d> quadratic_fields(const std::vector<Vec<d>>& X) {
  constexpr int size = QuadraticFields<d>::size;
  using Gram = Eigen::Matrix<double, size, size>;
  QuadraticFields<d> fields{Vec<d>::Zero(), 0, Gram::Zero()};
  for (const auto& x : X) fields.centre += x / static_cast<double>(X.size());
  for (const auto& x : X) fields.radius = std::max(fields.radius, (x - fields.centre).norm());
  Gram gram = Gram::Zero();
  for (const auto& x : X) {
    const auto q = fields.at(x);
    gram += q.transpose() * q;
  }
  const Eigen::SelfAdjointEigenSolver<Gram> eigen(gram);  // particles in one plane: some fields coincide
  for (int k = 0; k < size; ++k) {
    const auto& vector = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()[k] > 1e-13 * eigen.eigenvalues()[size - 1])
      fields.inverse_gram += vector * vector.transpose() / eigen.eigenvalues()[k];
  }
  return fields;
}

template <int d>
void remove_quadratics(const QuadraticFields<d>& fields, const std::vector<Vec<d>>& X, Multipliers<d>& r) {
  Eigen::Matrix<double, QuadraticFields<d>::size, lanes<d>> part;
  part.setZero();
  for (std::size_t i = 0; i < X.size(); ++i) part += fields.at(X[i]).transpose() * r[i].transpose();
  part = (fields.inverse_gram * part).eval();
  for (std::size_t i = 0; i < X.size(); ++i) r[i] -= (fields.at(X[i]) * part).transpose();
}

#define PLUMB_INSTANTIATE(d)                                                   \
  template struct QuadraticFields<d>;                                          \
  template QuadraticFields<d> quadratic_fields<d>(const std::vector<Vec<d>>&); \
  template void remove_quadratics<d>(const QuadraticFields<d>&, const std::vector<Vec<d>>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
