#pragma once
#include <Eigen/SparseCore>

#include "plumbline/compatible/area_vectors.hpp"

namespace plumb {

/// Values per constraint: row (d + 1) i is the closedness of particle i, rows (d + 1) i + 1 + b its exactness
/// in X_b; column a is the component of A. The transpose of the constraints takes the same shape.
using ConstraintValues = Eigen::MatrixXd;

/// What is missing: -B_i - sum_j A_ij, and V_i I - sum_j A_ij (x) X_ij / 2. THEORY (11.1), (11.2).
template <int d>
ConstraintValues missing(const AreaTable<d>& table);

/// Adds the weighted image of multipliers: A_ij += w_ij ((l_i - l_j) + (L_i + L_j) X_ij / 2),
/// V_i -= w_V tr L_i. THEORY (11.5).
template <int d>
void add_multipliers(AreaTable<d>& table, const ConstraintValues& multipliers, double volume_weight);

/// The normal matrix C W C^T, lower triangle. With fixed volumes (weight 0) the components of A do not see
/// each other: one matrix of (d + 1) N rows serves all. Otherwise d (d + 1) N rows, component by component
/// within each particle.
template <int d>
Eigen::SparseMatrix<double> normal_matrix(const AreaTable<d>& table, double volume_weight);

}  // namespace plumb
