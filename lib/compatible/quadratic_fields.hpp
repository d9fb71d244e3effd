#pragma once
#include "plumbline/compatible/bond_operator.hpp"

namespace plumb {

/// The fields l of degree 2 with L = grad l, which the normal matrix does not see on any cloud (THEORY
/// (11.6)): a basis, evaluated where it is needed, and its products.
template <int d>
struct QuadraticFields {
  static constexpr int size = (d + 1) * (d + 2) / 2;
  using Values = Eigen::Matrix<double, d + 1, size>;  ///< of one particle, one field per column
  Vec<d> centre;
  double radius;
  Eigen::Matrix<double, size, size> inverse_gram;

  Values at(const Vec<d>& X) const;
};

template <int d>
QuadraticFields<d> quadratic_fields(const std::vector<Vec<d>>& X);

/// Takes the part of r that lies along these fields out of it.
template <int d>
void remove_quadratics(const QuadraticFields<d>& fields, const std::vector<Vec<d>>& X, Multipliers<d>& r);

}  // namespace plumb
