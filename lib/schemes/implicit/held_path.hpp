#pragma once
#include <vector>

#include "lib/actions/actions.hpp"
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

}  // namespace plumb
