#pragma once
#include "lib/schemes/implicit/place_gradients.hpp"
#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// What the derivatives of an energy are made of at every displacement: dE/du = G^T w P + terms u and K = G^T w T G + terms, where only P
/// and T change with the motion. Everything is kept once.
template <int d>
struct EnergyOperators {
  Eigen::VectorXd identity;    ///< what G makes of the reference: I for every consistent estimator
  PlaceGradients<d> gradient;  ///< G [1/m]: F = identity + G u
  Eigen::VectorXd weight;      ///< w, the volume of every place [m^d]
  SparseMatrix
      half_of_terms;  ///< the lower half of the stiffness of terms between particles [N/m], the same for every component

  Eigen::VectorXd gradients(const Eigen::VectorXd& u) const { return identity + gradient.times(u); }
  /// Returns G^T w P + terms u [N].
  Eigen::VectorXd forces(const Eigen::VectorXd& P, const Eigen::VectorXd& u) const;
  /// Returns |terms| |u| [N].
  Eigen::VectorXd largest_of_terms(const Eigen::VectorXd& u) const;
  bool has_terms() const { return half_of_terms.nonZeros() > 0; }
  /// Returns the stiffness of terms, both halves.
  SparseMatrix terms() const { return SparseMatrix(half_of_terms.template selfadjointView<Eigen::Lower>()); }
};

/// The operators of a body of bonds with these terms. Throws InputError if the internal force is not the derivative of an energy,
/// which the adjoint form (5.3) alone is.
template <int d>
EnergyOperators<d> energy_operators(const Solid<d>& solid, const std::vector<Term<d>>& terms);

}  // namespace plumb
