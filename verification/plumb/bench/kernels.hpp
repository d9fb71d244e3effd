#pragma once
#include <string>
#include <vector>

namespace plumb::app::bench {

/// One loop of the solver on its own, in 3D at 26 neighbours, on one thread.
struct KernelTime {
  std::string kernel;  ///< "stress sweep", ..
  std::string cloud;   ///< "lattice" or "jittered"
  long particles;
  double ns_per_particle;  ///< CPU time
};

/// Measures every kernel by Google Benchmark on clouds of about `particles` particles, each for about
/// `seconds` CPU seconds.
std::vector<KernelTime> measure_kernels(long particles, double seconds);

}  // namespace plumb::app::bench
