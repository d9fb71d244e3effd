#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "lib/schemes/implicit/energy_operators.hpp"

namespace plumb {

/// F = identity + gradient u, numbered d^2 x place + d x row + column.
struct GradientOperator {
  Eigen::VectorXd identity;
  SparseMatrix gradient;  ///< [1/m]
};

/// An energy E(u) of the displacements of particles, as a scheme hands it to whoever seeks equilibria: bodies
/// of bonds and finite elements make one. Unknowns are numbered d x particle + component; u is in [m].
template <int d>
struct StoredEnergy {
  Cloud<d> cloud;  ///< the particles, with the volumes that masses and body forces go by
  Elastic elastic;
  Slots slots;  ///< of the particles in the fields of a state
  /// G and the constant stiffness of terms; copies of an energy share them. The law is asked at particles, or at points in elements.
  std::shared_ptr<const EnergyOperators<d>> operators;
  std::optional<GradientOperator> at_particles;            ///< for pressures that follow; nullopt: G itself
  std::function<double(const Eigen::VectorXd& u)> energy;  ///< E [J]
  /// dE/du [N]; nullopt if some J is not positive.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& u)> residual;
  std::function<Tangent<d>(const Mat<d>& F, Index place)> tangent;  ///< dP/dF of the law there [Pa]
  /// Moves the history of the law to the displacements u of an equilibrium or of a step's end; empty: it has none. Energy, residual
  /// and tangent are those of the increment since.
  std::function<void(const Eigen::VectorXd& u)> commit = {};
  std::function<std::optional<Trouble>()> trouble;  ///< where the last residual had no positive J, if it had
  double round_off = 0;                             ///< of E near the reference [J]
};

/// The energy of a body of bonds: sum V W(F) and the energies of its terms (hourglass), without what is no energy: loads and supports,
/// which act from outside, and dissipation, for nothing moves. Terms that are added to the body later do not count. Throws InputError if
/// the internal force has no energy.
template <int d>
StoredEnergy<d> stored_energy(std::shared_ptr<const Solid<d>> solid);
/// That of a copy of the body.
template <int d>
StoredEnergy<d> stored_energy(const Solid<d>& solid) {
  return stored_energy<d>(std::make_shared<const Solid<d>>(solid));
}

}  // namespace plumb
