#pragma once
#include <string>

#include "reports/plot/prepare.hpp"

namespace plumb::reports::plot {

/// Text as a gnuplot string: in double quotes, nothing in it can act as a command.
std::string literal(const std::string& text);

/// "label [unit]", or the label alone for a pure number.
std::string with_unit(const std::string& label, const std::string& unit);

/// Commands for one axis ("x", "y" or "cb"): range, logarithm, numbers on it.
std::string axis_commands(const std::string& name, const Range& range, const std::vector<double>& ticks);

/// A number as short text for an axis: plain from 1e-3 to 1e5, else as a power of ten.
std::string tick_text(double value);

}  // namespace plumb::reports::plot
