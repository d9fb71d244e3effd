#pragma once
#include <string>
#include <vector>

#include "reports/body.hpp"

namespace plumb::reports {

/// The one number of a drawn body that is held against another (body_numbers.hpp).
enum class Compared { angular_momentum, corner, rotation, stress, start_energy, length, period };

/// A run whose last state the report draws.
struct DrawnBody {
  std::string id, name, scene;   ///< scene: the name of a file of verification/scenes
  std::vector<std::string> set;  ///< KEY=VALUE over the scene
  View view;
  double spacing;  ///< [m]
  Compared compared;
  bool moves = false;  ///< states on the way are drawn too
};

/// Reduced runs of sections 5.2 to 5.5 of paper 000; seconds each.
std::vector<DrawnBody> reduced_bodies();
/// The sizes and end times of the papers; minutes each.
std::vector<DrawnBody> paper_size_bodies();

}  // namespace plumb::reports
