#pragma once

namespace plumb::bench {

/// What one core does when nothing stands in its way: the limits that a solver is held against.
struct Machine {
  double fma_gflops;  ///< fused multiply-adds on registers, two operations each [1e9/s]
  double triad_gbs;   ///< a = b + s c on arrays far larger than the caches, 24 bytes an entry [1e9 byte/s]
};

/// Measures both, in about half a second.
Machine measure_machine();

}  // namespace plumb::bench
