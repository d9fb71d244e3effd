#pragma once
#include <algorithm>
#include <vector>

#include "lib/kernel/kernel.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Holds what an optional part of a scheme may need when it is added to a body.
template <int d>
struct PartSite {
  Solid<d>& solid;
  const RadialKernel<d>& kernel;
  double real_axis;  ///< the integrator's bound of lambda dt on the negative real axis, THEORY (6.5)
  std::vector<double> radius = {};  ///< of each particle's support [m]; empty: that of the kernel

  /// Keeps the time step below `limit` [s].
  void limit_step(double limit) { solid.step_limit = std::min(solid.step_limit, limit); }
};

}  // namespace plumb
