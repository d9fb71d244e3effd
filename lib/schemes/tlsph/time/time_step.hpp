#pragma once
#include <string_view>

#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Speed of (31), (32) that divides the pair distance.
enum class WaveSpeed {
  linear,          ///< C_p^Lin alone
  stretch,         ///< C_p^Lin times the mean least stretch of the pair: the reading that fits Table 1
  stretch_inverse  ///< C_p^Lin over the mean least stretch: as (32) prints it
};

std::string_view name_of(WaveSpeed speed);
WaveSpeed wave_speed_named(std::string_view name);

/// min over pairs r_ij / C_p,ij [s] in the current state: the step of (31), THEORY (7.3), at alpha = 1.
template <int d>
double crossing_time(const Solid<d>& solid, const State<d>& state, WaveSpeed speed);

}  // namespace plumb
