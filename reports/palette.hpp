#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace plumb::reports {

/// One colour of the palette in its three uses, each as "#RRGGBB".
struct Ink {
  std::string_view line;  ///< lines, points and fills on white
  std::string_view text;  ///< the same hue, dark enough for small text on white
  std::string_view dark;  ///< all of these on a dark page
};

/// Colours that colour-blind readers can tell apart (M. Okabe and K. Ito, "Color universal design", 2008),
/// without the yellow, which cannot be seen on white. Series also differ in point shape and name, so print
/// without colour works.
inline constexpr std::array<Ink, 7> palette{{{"#0072b2", "#00588a", "#5ab4e8"},
                                             {"#d55e00", "#a84a00", "#f08a45"},
                                             {"#009e73", "#00714f", "#3ccba0"},
                                             {"#cc79a7", "#9a4577", "#e3a3c6"},
                                             {"#e69f00", "#8a5f00", "#f3bd4a"},
                                             {"#56b4e9", "#20759f", "#9ad4f5"},
                                             {"#505050", "#404040", "#b8b8b8"}}};

/// The palette colour of series number `i`; it repeats after seven.
inline constexpr const Ink& ink(std::size_t i) {
  return palette[i % palette.size()];
}

/// Colours of a heat map from low to high: nine stops of viridis (S. van der Walt and N. Smith, 2015), whose
/// lightness rises evenly, so it also reads in grey.
inline constexpr std::array<std::string_view, 9> heat_stops{
    "#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"};

}  // namespace plumb::reports
