#pragma once
#include <Eigen/SparseCore>

#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// A sparse matrix over unknowns numbered d x particle + component.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Small motions about the reference state: M a = -K u. K comes from the same bond tables as the force, so it
/// is symmetric exactly when the momentum form is the adjoint of F. Terms add their own stiffness.
struct Linearised {
  SparseMatrix stiffness;  ///< K [N/m]
  Eigen::VectorXd mass;    ///< rho V of every unknown [kg]
};

/// K = -V D T G with G: u -> F, T = dP/dF at the reference state, D: P -> force per unit volume (THEORY
/// (3.1), (5.1)). Dissipation and supports are not in it.
template <int d>
Linearised linearise(const Solid<d>& solid);

/// What K is made of at every displacement: K = D T G + terms, where only T changes with the motion.
/// Deformation gradients and stresses are numbered d^2 x particle + d x row + column.
struct LinearOperators {
  Eigen::VectorXd identity;  ///< what the table makes of the reference: I for every consistent estimator
  SparseMatrix gradient;     ///< G [1/m]: F = identity + G u
  SparseMatrix force;        ///< D [m^(d-1)]: P -> minus the force on every particle
  SparseMatrix
      terms;  ///< stiffness of the terms [N/m] between particles, the same for every component; their energies are quadratic
};
/// The matrix that is such a one for each component.
SparseMatrix per_component(const SparseMatrix& between_particles, int components);
template <int d>
LinearOperators linear_operators(const Solid<d>& solid);

/// The lower half of the stiffness of these terms [N/m] between particles, the same for every component.
template <int d>
SparseMatrix half_of_terms(const Solid<d>& solid, const std::vector<Term<d>>& terms);
/// What the table makes of the reference, numbered as deformation gradients are: I for every consistent estimator.
template <int d>
Eigen::VectorXd gradients_of_reference(const Solid<d>& solid);

/// T at these deformation gradients: one material tangent dP/dF [Pa] per particle.
template <int d>
SparseMatrix tangent_operator(const Solid<d>& solid, const Eigen::VectorXd& gradients);

/// Reads a vector per particle from a field over slots (displacements, velocities), and writes it into one.
template <int d>
Eigen::VectorXd unknowns_of(const Solid<d>& solid, const Field& field);
template <int d>
void set_unknowns(const Solid<d>& solid, const Eigen::VectorXd& values, Field& field);
/// rho V of every unknown [kg].
template <int d>
Eigen::VectorXd masses_of(const Solid<d>& solid);

/// Unknowns that no support holds, ascending: `held` lists the others (any order, repeats allowed).
std::vector<Index> free_unknowns(Index unknowns, const std::vector<Index>& held);

/// Rows `rows` and columns `columns` of a matrix (both ascending).
SparseMatrix part_of(const SparseMatrix& matrix, const std::vector<Index>& rows,
                     const std::vector<Index>& columns);

}  // namespace plumb
