#pragma once
#include <optional>
#include <vector>

#include "lib/linear/known_product.hpp"
#include "lib/schemes/implicit/stored_energy.hpp"

namespace plumb {

/// The energy E(u) of a body with its first two derivatives, of which the second is a sparse matrix of chosen
/// unknowns. Unknowns are numbered d x particle + component; u is in [m].
template <int d>
class DiscreteEnergy {
 public:
  /// `unknowns`, ascending, are those that tangent() is asked for.
  DiscreteEnergy(StoredEnergy<d> energy, std::vector<Index> unknowns);
  /// The energy of a body of bonds. Throws InputError as stored_energy() does.
  DiscreteEnergy(const Solid<d>& solid, std::vector<Index> unknowns)
      : DiscreteEnergy(stored_energy(solid), std::move(unknowns)) {}

  /// Returns E [J].
  double energy(const Eigen::VectorXd& u) const { return stored_.energy(u); }
  /// Returns dE/du [N]: minus the internal force on every particle; nullopt if some J is not positive.
  std::optional<Eigen::VectorXd> residual(const Eigen::VectorXd& u) const { return stored_.residual(u); }
  /// Returns F of every particle, numbered d^2 x particle + d x row + column.
  Eigen::VectorXd particle_gradients(const Eigen::VectorXd& u) const;
  /// Returns what a displacement adds to them.
  Eigen::VectorXd change_of_gradients(const Eigen::VectorXd& v) const;
  /// Returns their derivative by u [1/m].
  SparseMatrix particle_operator() const;

  /// Moves the second derivative K = d2E/du2 [N/m] to the displacements u, THEORY (15.2).
  void linearise_at(const Eigen::VectorXd& u);
  /// Returns K of the chosen unknowns there.
  SparseMatrix tangent();
  /// Returns K v for all unknowns there, without a matrix.
  Eigen::VectorXd tangent_times(const Eigen::VectorXd& v) const;

  /// Returns what rounding of F by half a unit leaves of dE/du there [N]: |D| |T| |F| half a unit. At strains
  /// of 1e-9 that is 1e-7 of the forces.
  double residual_round_off(const Eigen::VectorXd& u) const;

  /// Returns |D| |T| |G| |u| + |terms| |u| where it was linearised last [N]: no smaller than |K| |u|.
  Eigen::VectorXd largest_products(const Eigen::VectorXd& u) const;

  const EnergyOperators<d>& operators() const { return *stored_.operators; }
  const SparseMatrix& material() const { return material_; }  ///< T, where it was linearised last
  const Cloud<d>& cloud() const { return stored_.cloud; }
  const Elastic& elastic() const { return stored_.elastic; }
  /// Returns rho V of every unknown [kg].
  Eigen::VectorXd masses() const;
  const Slots& slots() const { return stored_.slots; }
  double round_off() const { return stored_.round_off; }  ///< of E near the reference [J]
  /// Says that the body is at u for good: a law with history moves it there.
  void commit(const Eigen::VectorXd& u) {
    if (stored_.commit) stored_.commit(u);
  }
  /// Where the last residual had no J > 0, if it had.
  std::optional<Trouble> trouble() const { return stored_.trouble(); }
  const std::vector<Index>& unknowns() const { return unknowns_; }

 private:
  void take_parts();

  StoredEnergy<d> stored_;
  std::vector<Index> unknowns_;
  SparseMatrix gradient_part_, force_part_,
      terms_part_;                   ///< of the chosen unknowns, once the tangent is asked for
  SparseMatrix material_;            ///< T
  KnownProduct stress_, stiffness_;  ///< T G and D T G
};

}  // namespace plumb
