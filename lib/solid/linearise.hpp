#pragma once
#include <Eigen/SparseCore>

#include "plumbline/solid/solid.hpp"

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

/// Unknowns that no support holds, ascending: `held` lists the others (any order, repeats allowed).
std::vector<Index> free_unknowns(Index unknowns, const std::vector<Index>& held);

/// Rows `rows` and columns `columns` of a matrix (both ascending).
SparseMatrix part_of(const SparseMatrix& matrix, const std::vector<Index>& rows,
                     const std::vector<Index>& columns);

}  // namespace plumb
