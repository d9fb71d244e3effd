#pragma once
#include <string>
#include <vector>

#include "reports/plot/prepare.hpp"

namespace plumb::reports::plot {

/// gnuplot's commands for the map of a picture and its data; what is to be plotted is added to `plots`.
std::string map_commands(const Prepared& prepared, std::vector<std::string>& plots);

}  // namespace plumb::reports::plot
