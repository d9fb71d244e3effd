#pragma once
#include <cmath>

#include "lib/core/pack.hpp"

namespace plumb {

/// Lane by lane the square root.
template <int W>
Pack<W> sqrt(const Pack<W>& x) {
  double values[W];
  x.store(values);
  for (double& value : values) value = std::sqrt(value);
  return Pack<W>::load(values);
}

}  // namespace plumb
