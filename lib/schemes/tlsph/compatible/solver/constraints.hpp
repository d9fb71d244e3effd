#pragma once
#include <Eigen/SparseCore>

#include "lib/schemes/tlsph/compatible/solver/bond_operator.hpp"

namespace plumb {

/// What is missing: -B_i - sum_j A_ij, and V_i I - sum_j A_ij (x) X_ij / 2. THEORY (11.1), (11.2).
template <int d>
Multipliers<d> missing(const AreaTable<d>& table);

/// Adds the weighted image of multipliers: A_ij += w_ij ((l_i - l_j) + (L_i + L_j) X_ij / 2), and
/// V_i -= w_V tr L_i. THEORY (11.5).
template <int d>
void add_multipliers(AreaTable<d>& table, const BondOperator<d>& N, const Multipliers<d>& x);

/// What that changes A_ij by.
template <int d>
Vec<d> image(const AreaVector<d>& pair, const Multipliers<d>& x);

/// The normal matrix C W C^T, lower triangle. With fixed volumes the components of A do not see each other:
/// one matrix of (d + 1) N rows serves all. Otherwise d (d + 1) N rows, component by component within each
/// particle.
template <int d>
Eigen::SparseMatrix<double> normal_matrix(const AreaTable<d>& table, const BondOperator<d>& N);

/// Largest absolute value of an entry.
template <int d>
double largest(const Multipliers<d>& values);

}  // namespace plumb
