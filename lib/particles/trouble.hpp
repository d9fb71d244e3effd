#pragma once
#include <optional>
#include <string>

#include "lib/core/types.hpp"

namespace plumb {

/// Where and why a step could not be made.
struct Trouble {
  std::optional<Index> particle;  ///< nothing: it belongs to no particle
  std::string quantity;           ///< "determinant of F", "density", "residual" ..
  double value;
};

}  // namespace plumb
