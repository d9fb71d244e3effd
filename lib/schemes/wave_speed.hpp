#pragma once
#include <string_view>

namespace plumb {

/// Speed of (31), (32) that divides the pair distance.
enum class WaveSpeed {
  linear,          ///< C_p^Lin alone
  stretch,         ///< C_p^Lin times the mean least stretch of the pair: the reading that fits Table 1
  stretch_inverse  ///< C_p^Lin over the mean least stretch: as (32) prints it
};

/// Translates between wave speeds and their names in scenes. InputError names the nearest valid name.
std::string_view name_of(WaveSpeed speed);
WaveSpeed wave_speed_named(std::string_view name);

}  // namespace plumb
