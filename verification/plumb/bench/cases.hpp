#pragma once
#include <string>
#include <vector>

#include "lib/scene/scene.hpp"

namespace plumb::app::bench {

/// A scheme on a kind of cloud, whose speed is measured at any size.
struct Case {
  std::string name;  ///< "adjoint-verlet-3d", "paper-2d-jittered", ..
  Scene scene;       ///< without spacing
  bool main;         ///< one of the few that are measured unless all are asked for
  long most = 0;     ///< particles; 0: no limit (the projection of compatible bonds costs more than N)
};

/// Every scheme, in 2D and 3D, on a lattice and on a jittered cloud.
const std::vector<Case>& cases();

/// What a whole run of some steps cost: boundaries, time step control and everything else of run() included.
struct Speed {
  long particles = 0;
  int threads = 1;
  double updates_per_cpu_s = 0;  ///< evaluations of stress and force for one particle; best of the repeats
  double updates_per_wall_s = 0;
  double setup_cpu_s = 0, setup_wall_s = 0;
  double bytes_per_particle = 0;  ///< of the arrays that `plumb explain` lists
  double bytes_per_update = 0;    ///< that it reads and writes, THEORY (10.8)
  double flops_per_update = 0;  ///< of the plain sums: 2 d^2 products for F and for the force, d differences
};

/// Runs the case with about `particles` particles for about `seconds` CPU seconds per repeat.
Speed measure(const Case& c, long particles, int threads, int repeats, double seconds);

}  // namespace plumb::app::bench
