#pragma once
#include <functional>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/geometry/layout.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Names one component of one particle whose motion is prescribed, with its velocity at the start.
template <int d>
struct Support {
  Index particle;
  int component;
  double velocity = 0;  ///< [m/s]
};

/// Particles on a face of the body's box (axis 0..d-1, upper or lower). Cell and mirror layouts: the first
/// particle layer.
template <int d>
std::vector<Index> particles_on_face(const Cloud<d>& cloud, int axis, bool upper, Layout layout);

/// All particles for which the predicate on X holds.
template <int d>
std::vector<Index> particles_where(const Cloud<d>& cloud,
                                   const std::function<bool(const Vec<d>&)>& predicate);

/// Makes the action that holds these components at their constant velocities.
template <int d>
Actions<d> holding(const Cloud<d>& cloud, const std::vector<Support<d>>& supports);

/// Lists the held components of all boundaries with their velocities at the start.
template <int d>
std::vector<Support<d>> supports_of(const Actions<d>& actions);

}  // namespace plumb
