#pragma once
#include "lib/core/types.hpp"

namespace plumb {

/// Returns the vector with three components; what is missing is 0.
template <int d>
Vec<3> in_space(const Vec<d>& v) {
  Vec<3> w = Vec<3>::Zero();
  w.template head<d>() = v;
  return w;
}

}  // namespace plumb
