#pragma once
#include <optional>
#include <vector>

#include "plumbline/linear/known_product.hpp"
#include "plumbline/solid/linearise.hpp"

namespace plumb {

/// The energy of a body as a function of the displacements u of its particles,
///   E(u) = sum V W(F(u)) + energies of its terms (hourglass),
/// with its first two derivatives. Whatever the bond table, the law and the terms are, they define E.
/// Unknowns are numbered d x particle + component; u is in [m].
template <int d>
class DiscreteEnergy {
 public:
  /// Takes a copy of the body without what is no energy: loads and supports, which act from outside, and
  /// dissipation, for nothing moves. `unknowns`, ascending, are those that tangent() is asked for. Throws
  /// InputError if the internal force has no energy.
  DiscreteEnergy(const Solid<d>& solid, std::vector<Index> unknowns);

  /// Returns E [J].
  double energy(const Eigen::VectorXd& u);
  /// Returns dE/du [N]: minus the internal force on every particle; nullopt if some J is not positive.
  std::optional<Eigen::VectorXd> residual(const Eigen::VectorXd& u);
  /// Returns F of every particle, numbered d^2 x particle + d x row + column.
  Eigen::VectorXd gradients(const Eigen::VectorXd& u) const;

  /// Moves the second derivative K = d2E/du2 [N/m] to the displacements u, THEORY (15.2).
  void linearise_at(const Eigen::VectorXd& u);
  /// Returns K of the chosen unknowns there.
  SparseMatrix tangent();
  /// Returns K v for all unknowns there, without a matrix.
  Eigen::VectorXd tangent_times(const Eigen::VectorXd& v) const;

  const Solid<d>& solid() const { return solid_; }
  const std::vector<Index>& unknowns() const { return unknowns_; }
  const LinearOperators& operators() const { return operators_; }

 private:
  const State<d>& state_at(const Eigen::VectorXd& u);

  Solid<d> solid_;
  State<d> state_;
  std::vector<Index> unknowns_;
  LinearOperators operators_;                             ///< of all unknowns
  SparseMatrix gradient_part_, force_part_, terms_part_;  ///< of the chosen ones
  SparseMatrix material_;                                 ///< T
  KnownProduct stress_, stiffness_;                       ///< T G and D T G
};

}  // namespace plumb
