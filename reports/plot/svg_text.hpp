#pragma once
#include <string>

#include "reports/picture.hpp"

namespace plumb::reports::plot {

/// Makes gnuplot's SVG fit for a page: no names of programs, ids that start with `prefix`, a title for screen
/// readers, each series named for the pointer, colours as #rrggbb, and a style that follows the reader's dark
/// mode.
std::string tidy_svg(std::string svg, const Picture& picture, const std::string& prefix);

/// The text with & < > " ' written so that it is safe inside HTML and XML, also in attributes.
std::string escaped(const std::string& text);

}  // namespace plumb::reports::plot
