#pragma once
#include "lib/schemes/tlsph/compatible/solver/bond_operator.hpp"

namespace plumb {

/// The fields l of degree 2 with L = grad l. With fixed volumes the normal matrix does not see them on any
/// cloud, otherwise those without divergence (THEORY (11.6)).
template <int d>
struct QuadraticFields {
  static constexpr int scalars = (d + 1) * (d + 2) / 2, size = d * scalars;
  using Values = Eigen::Matrix<double, d + 1, scalars>;  ///< of one particle, one scalar field per column
  Vec<d> centre;
  double radius;
  /// Coefficients of fields (those of component 0 first) from products with them.
  Eigen::MatrixXd along_null;  ///< of the part in the null space

  Values at(const Vec<d>& X) const;
};

/// Makes the fields of the particles of a matrix.
template <int d>
QuadraticFields<d> quadratic_fields(const BondOperator<d>& N);

/// Takes the part of r that lies in the null space out of it.
template <int d>
void remove_null_part(const QuadraticFields<d>& fields, const std::vector<Vec<d>>& X, Multipliers<d>& r);

}  // namespace plumb
