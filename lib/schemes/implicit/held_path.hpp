#pragma once
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/actions/boundary_force.hpp"
#include "lib/schemes/implicit/external_loads.hpp"

namespace plumb {

/// Lists the unknowns that boundaries hold, ascending, each once.
template <int d>
std::vector<Index> held_unknowns(const Actions<d>& actions);

/// Puts the held unknowns of `u` where they are at a point of the path: at their prescribed displacements, or
/// as far from `start` as their prescribed velocity has taken them. If two boundaries hold an unknown, the
/// later one wins.
template <int d>
void put_held(const Actions<d>& actions, const PathPoint& at, const Eigen::VectorXd& start,
              Eigen::VectorXd& u);

/// Returns the force of every boundary that holds the body [N], out of the residual of all unknowns.
template <int d>
std::vector<BoundaryForce<d>> forces_of_supports(const Actions<d>& actions, Eigen::VectorXd residual);

}  // namespace plumb
