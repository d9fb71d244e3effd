#pragma once
#include <vector>

#include "plumbline/actions/actions.hpp"
#include "plumbline/solid/linearise.hpp"

namespace plumb {

/// Says how far the loads of a quasi-static path have grown: from share 0 to share 1 at its end time. What
/// varies in time is taken at the time of the share; what is constant grows in proportion to the share.
struct PathPoint {
  double share;     ///< 0 to 1
  double end_time;  ///< [s]
  double time() const { return share * end_time; }
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
