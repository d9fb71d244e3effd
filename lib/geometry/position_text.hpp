#pragma once
#include <fmt/format.h>

#include <string>

#include "lib/core/types.hpp"

namespace plumb {

/// "(x, y, z)" with six digits, for messages.
template <int d>
std::string position_text(const Vec<d>& X) {
  std::string text;
  for (int k = 0; k < d; ++k) text += fmt::format("{}{:.6g}", k ? ", " : "", X[k]);
  return "(" + text + ")";
}

}  // namespace plumb
