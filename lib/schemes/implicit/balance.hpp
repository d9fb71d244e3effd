#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/schemes/implicit/discrete_energy.hpp"
#include "lib/schemes/implicit/external_loads.hpp"
#include "lib/schemes/implicit/held_path.hpp"

namespace plumb {

/// The balance of internal and external forces of a body on its path: r(u) = dE/du - f(u), zero at the
/// unknowns that no boundary holds. THEORY (15.1).
template <int d>
class Balance {
 public:
  /// `u`: the displacements where the path begins. The actions must outlive it.
  Balance(StoredEnergy<d> energy, const Actions<d>& actions, const PathPoint& from, const Eigen::VectorXd& u);
  Balance(const Solid<d>& solid, const Actions<d>& actions, const PathPoint& from, const Eigen::VectorXd& u)
      : Balance(stored_energy(solid), actions, from, u) {}

  /// Moves to another point of the path.
  void move_to(const PathPoint& at);
  /// Takes weight (u - target) from the external forces, component by component: the inertia of a step in
  /// time, THEORY (15.5).
  void set_inertia(Eigen::VectorXd weight, Eigen::VectorXd target);
  /// Returns r of all unknowns [N]: at held ones the force of the support; nullopt if some J is not positive.
  std::optional<Eigen::VectorXd> residual(const Eigen::VectorXd& u) const;
  /// Moves the tangent dr/du to the displacements u.
  void linearise_at(const Eigen::VectorXd& u);
  /// Returns dr/du of the free unknowns there [N/m]; symmetric unless a pressure follows.
  SparseMatrix tangent();
  /// Returns dr/du v for all unknowns there.
  Eigen::VectorXd tangent_times(const Eigen::VectorXd& v) const;
  /// Returns the change of the potential E - (work of the loads) over a straight step [J], without round-off
  /// of that size or less; `round_off` gets a bound of it. THEORY (15.3).
  double change_of_potential(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double* round_off);
  /// Returns the norm of the external forces and of all internal ones [N]: what residuals are relative to.
  double force_scale(const Eigen::VectorXd& u, const Eigen::VectorXd& residual) const;
  /// Puts the held unknowns of u where they are at this point.
  void put_held(Eigen::VectorXd& u) const { plumb::put_held(actions_, at_, start_, u); }
  /// Returns the part of a vector that belongs to free unknowns, and a whole one with zeros elsewhere.
  Eigen::VectorXd free_part(const Eigen::VectorXd& all) const;
  Eigen::VectorXd whole(const Eigen::VectorXd& free) const;

  const Eigen::VectorXd& inertia() const { return weight_; }  ///< the weight of set_inertia(); empty without
  bool symmetric() const { return !loads_.follow(); }
  DiscreteEnergy<d>& energy() { return energy_; }
  const DiscreteEnergy<d>& energy() const { return energy_; }
  const std::vector<Index>& held() const { return held_; }

 private:
  Eigen::VectorXd external(const Eigen::VectorXd& u) const;

  const Actions<d>& actions_;
  std::vector<Index> held_;
  DiscreteEnergy<d> energy_;
  ExternalLoads<d> loads_;
  PathPoint at_;
  Eigen::VectorXd start_;  ///< displacements at time 0, as far as velocities are prescribed
  Eigen::VectorXd dead_;
  Eigen::VectorXd weight_, target_;  ///< of the inertia; empty without
  SparseMatrix following_;           ///< df/dF of pressures
};

}  // namespace plumb
