#pragma once
#include <string>
#include <vector>

namespace plumb {

/// The symbols that parse_measured() knows, each once and without prefixes, and the prefixes.
std::vector<std::string> unit_names();
std::vector<std::string> prefix_names();

}  // namespace plumb
