#pragma once
#include <string>

namespace plumb {

/// The line of a bar: "study [###...]  12 %, 5 %/s, 18 s left, level 3", at most `columns` characters. Where
/// there is no room the bar goes first, then the ends of note and label.
std::string bar_line(const std::string& label, double fraction, const std::string& left,
                     const std::string& note, std::size_t columns);

}  // namespace plumb
