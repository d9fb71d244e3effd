#pragma once
#include <string>

#include "reports/plot/prepare.hpp"

namespace plumb::reports::plot {

enum class Format { svg, png };

/// The gnuplot commands, with the data in them, that draw the picture into `output`.
std::string script(const Prepared& prepared, Format format, const std::string& output);

}  // namespace plumb::reports::plot
