#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/core/types.hpp"

/// What acts on a body from outside. Scenes and manufactured solutions both make an Actions value; every
/// scheme applies it after its own forces.
namespace plumb {

/// Describes how one held component moves at one instant.
struct HeldMotion {
  std::optional<double> displacement;  ///< [m]; nullopt: it follows from the velocity
  double velocity = 0;                 ///< [m/s]
  double acceleration = 0;             ///< [m/s^2]
};

/// Names one component of one particle that does not move freely.
template <int d>
struct HeldPlace {
  Index particle;
  int component;
  Vec<d> at;  ///< reference point that the motion is asked at [m]: the particle's, or one of a face beside it
};

/// Holds components of particles on a path in time.
template <int d>
struct Held {
  std::string name;  ///< of the boundary
  std::vector<HeldPlace<d>> places;
  /// Gives the motion of a component at a point [m] and a time [s]. May be called by several threads.
  std::function<HeldMotion(const Vec<d>& at, int component, double time)> motion;
  /// Says that the velocity never changes: the motion is then asked once, at the start.
  bool steady = true;
};

/// Names a piece of the surface of which one particle has a part.
template <int d>
struct LoadedPlace {
  Index particle;
  Vec<d> at;         ///< reference point that the load is asked at [m]
  Vec<d> area;       ///< outward normal times area in the reference [m^(d-1)]
  double share = 1;  ///< of the piece that the particle carries; negative where others carry more than all

  double size() const { return share * area.norm(); }  ///< [m^(d-1)]
  Vec<d> normal() const { return area / area.norm(); }
};

/// Loads particles through pieces of the surface: by a traction, which keeps its direction, or by a pressure,
/// which follows the surface. Exactly one of the two functions is there.
template <int d>
struct SurfaceLoad {
  std::string name;  ///< of the boundary
  std::vector<LoadedPlace<d>> places;
  /// Force per reference area [Pa] at a point [m], with its outward normal, at a time [s].
  std::function<Vec<d>(const Vec<d>& at, const Vec<d>& normal, double time)> traction;
  /// Pressure per current area [Pa]; its force is -p cof(F) N per reference area (Nanson).
  std::function<double(const Vec<d>& at, double time)> pressure;
  bool steady = false;  ///< the function does not depend on time
};

/// Loads every particle by a force per reference volume.
template <int d>
struct BodyForce {
  std::string name;
  std::function<Vec<d>(const Vec<d>& X, double time)> per_volume;  ///< [N/m^d]
  bool steady = false;                                             ///< the function does not depend on time
};

/// Lists all that acts on a body from outside. Empty lists: nothing does.
template <int d>
struct Actions {
  std::vector<Held<d>> held;
  std::vector<SurfaceLoad<d>> surface;
  std::vector<BodyForce<d>> body_forces;

  bool has_loads() const { return !surface.empty() || !body_forces.empty(); }
};

/// Counts the held components of all boundaries.
template <int d>
std::size_t held_components(const Actions<d>& actions) {
  std::size_t count = 0;
  for (const auto& held : actions.held) count += held.places.size();
  return count;
}

}  // namespace plumb
