#pragma once
#include <optional>
#include <string>

#include "lib/scene/tlsph.hpp"

namespace plumb::app {

/// What projecting the scene's compatible table is going to take.
struct ProjectionCost {
  std::string why;  ///< it is projected, as the end of a sentence that begins with "because"
  double cpu_s;     ///< expected
};

/// For gradient = "compatible". By powers of the number of particles that were fitted to measurements (THEORY
/// chapter 11); a factor of two is to be expected from machine to machine. nullopt if nothing is projected.
template <int d>
std::optional<ProjectionCost> projection_cost(const Scene& scene, const Cloud<d>& cloud);

/// The same as a line for people; empty if nothing is projected.
std::string text_of(const std::optional<ProjectionCost>& cost);

}  // namespace plumb::app
