#pragma once
#include <string_view>

#include "reports/picture.hpp"

namespace plumb::reports {

/// Gives a series the colour and the point shape of a paper's scheme, the same in every picture: "000" to
/// "004" are the first five of the palette, finite elements are grey. As printed: dashed, with hollow points.
inline Series look_of(Series series, std::string_view paper, bool printed) {
  constexpr std::size_t grey = 6;
  const bool numbered = paper.size() == 3 && paper.substr(0, 2) == "00" && paper[2] >= '0' && paper[2] <= '4';
  series.colour = numbered ? static_cast<std::size_t>(paper[2] - '0') : grey;
  series.dashed = series.hollow = printed;
  return series;
}

}  // namespace plumb::reports
