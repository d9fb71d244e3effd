#include "lib/schemes/wave_speed.hpp"

#include <array>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

constexpr std::array<std::pair<WaveSpeed, std::string_view>, 3> speed_names = {
    {{WaveSpeed::linear, "linear"},
     {WaveSpeed::stretch, "stretch"},
     {WaveSpeed::stretch_inverse, "stretch-inverse"}}};

}  // namespace

std::string_view name_of(WaveSpeed speed) {
  return speed_names[static_cast<std::size_t>(speed)].second;
}

WaveSpeed wave_speed_named(std::string_view name) {
  std::vector<std::string> valid;
  for (const auto& [speed, text] : speed_names) {
    if (text == name) return speed;
    valid.emplace_back(text);
  }
  throw unknown_name("wave speed", name, valid);
}

}  // namespace plumb
