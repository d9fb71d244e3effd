#pragma once
#include <array>
#include <functional>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/geometry/cloud.hpp"
#include "lib/geometry/facets.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/compatible/flat_sides.hpp"

namespace plumb {

/// Returns the point at which expressions of X, Y, Z are asked.
std::array<double, 3> coordinates_of(const auto& X) {
  std::array<double, 3> point{0, 0, 0};
  for (int k = 0; k < X.size(); ++k) point[k] = X[k];
  return point;
}

/// Evaluates one formula per component at X [m] and a time [s].
template <int d>
Vec<d> evaluate_at(const std::vector<Expression>& expressions, const Vec<d>& X, double time = 0) {
  Vec<d> value;
  for (int k = 0; k < d; ++k) value[k] = expressions[k].at(coordinates_of(X), time);
  return value;
}

/// The time of a scene over which its formulas change [s]: one second if it ends by its number of steps.
inline double time_scale_of(const Scene& scene) {
  return scene.end_time.value_or(1);
}

/// Makes what [load] and the [[boundary]] tables of a scene do to its particles. `facets` is asked for the
/// pieces of the surface if a boundary loads them, `sides` for the flat sides that they make, where a compatible table knows who
/// shares them; otherwise a piece loads its owner. `time_scale` [s]: formulas change little in a thousandth
/// of it. Throws InputError where a boundary meets no particle or no surface.
template <int d>
Actions<d> actions_of_scene(const Cloud<d>& cloud, const Scene& scene,
                            const std::function<std::vector<Facet<d>>()>& facets, double time_scale,
                            const std::function<std::vector<FlatSide<d>>()>& sides = {});

/// Refuses two boundaries that hold one component on different paths; they may meet in a particle if they say
/// the same of each component. Throws InputError.
template <int d>
void refuse_contradictions(const Cloud<d>& cloud, const Actions<d>& actions, double time_scale);

}  // namespace plumb
