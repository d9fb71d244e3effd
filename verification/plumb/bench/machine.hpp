#pragma once

namespace plumb::app::bench {

/// What a number of cores does when nothing stands in its way: the limits that a solver is held against.
struct Machine {
  int threads;        ///< at work at the same time
  double fma_gflops;  ///< of all of them: fused multiply-adds on registers, two operations each [1e9/s]
  double triad_gbs;   ///< of all of them: a = b + s c on arrays far larger than the caches, 24 bytes an entry
                      ///< [1e9 byte/s]
};

/// Measures both in wall time, the best of some tries, in about half a second.
Machine measure_machine(int threads);

}  // namespace plumb::app::bench
