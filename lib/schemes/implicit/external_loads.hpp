#pragma once
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// Says when loads and supports act, and how far those that are constant have grown: what varies in time is
/// taken at this time.
struct PathPoint {
  double time;    ///< [s]
  double growth;  ///< what constant loads and displacements are multiplied by: 0 to 1
};

/// The forces that act on the particles of a body from outside, and how they change with its motion. Unknowns
/// are numbered d x particle + component, deformation gradients d^2 x particle + d x row + column.
template <int d>
class ExternalLoads {
 public:
  ExternalLoads(const Cloud<d>& cloud, const Actions<d>& actions) : cloud_(cloud), actions_(actions) {}

  /// Returns the forces that do not follow the motion [N]: tractions, gravity, body forces.
  Eigen::VectorXd dead(const PathPoint& at) const;
  /// True if a pressure follows the surface. Its force has no potential in general.
  bool follow() const;
  /// Returns the forces -p cof(F) N A of pressures [N], with F of the particle that carries the surface.
  Eigen::VectorXd following(const PathPoint& at, const Eigen::VectorXd& gradients) const;
  /// Returns their derivative by the deformation gradients [N].
  SparseMatrix following_tangent(const PathPoint& at, const Eigen::VectorXd& gradients) const;

 private:
  template <class Use>
  void for_each_pressure(const PathPoint& at, Use&& use) const;

  const Cloud<d>& cloud_;
  const Actions<d>& actions_;
};

}  // namespace plumb
