#pragma once
#include <optional>

#include "lib/schemes/implicit/newton.hpp"

namespace plumb {

/// An equilibrium on a path of loads that may rise and fall.
struct ArcPoint {
  Eigen::VectorXd u;   ///< displacements of all unknowns [m]
  double load = 0;     ///< what the loads are multiplied by
  int iterations = 0;  ///< of the search that found it
};

/// Follows the equilibria of a body under dead loads through limit points, where a search at given loads
/// finds none nearby: load and displacements are sought together, at a given distance from the last point.
/// THEORY (15.14).
template <int d>
class ArcLengthPath {
 public:
  /// Begins at rest without load. Loads and supports must be constant in time, supports at rest; the actions
  /// must outlive the path. Throws InputError otherwise.
  ArcLengthPath(const StoredEnergy<d>& energy, const Actions<d>& actions, double tolerance = 1e-10);

  /// Goes on by a step whose displacements change by `length` [m] in the Euclidean norm of all unknowns, or
  /// by half of it, a quarter .. where the search fails. nullopt if it fails at a thousandth, too: the point
  /// stays.
  std::optional<ArcPoint> step(double length);
  const ArcPoint& point() const { return point_; }
  /// Returns the step of all unknowns that led there [m]; zero at the start.
  Eigen::VectorXd last_step() const;
  /// Goes on as another path that has come there by that step of all unknowns.
  void go_on_from(const ArcPoint& point, const Eigen::VectorXd& last_step);
  /// Returns what the supports do to the body there, boundary by boundary.
  std::vector<BoundaryForce<d>> reactions();

 private:
  std::optional<ArcPoint> try_step(double length);
  /// The residual of all unknowns under that load; nullopt if some J is not positive.
  std::optional<Eigen::VectorXd> residual(const Eigen::VectorXd& u, double load);

  const Actions<d>& actions_;
  double tolerance_;
  Balance<d> balance_;
  Eigen::VectorXd load_;  ///< of the free unknowns, for load 1 [N]
  ArcPoint point_;
  Eigen::VectorXd last_;  ///< step that led there, of the free unknowns; empty at the start
};

}  // namespace plumb
