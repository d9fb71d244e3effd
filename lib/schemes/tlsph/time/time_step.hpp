#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/wave_speed.hpp"

namespace plumb {

/// min over pairs r_ij / C_p,ij [s] in the current state: the step of (31), THEORY (7.3), at alpha = 1.
template <int d>
double crossing_time(const Solid<d>& solid, const State<d>& state, WaveSpeed speed);

}  // namespace plumb
