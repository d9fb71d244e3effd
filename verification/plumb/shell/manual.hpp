#pragma once
#include <string>

namespace CLI {
class App;
}

namespace plumb::app {

/// The manual page plumb(1) as roff, from the same texts as the help. `date`: of this version, "2026-11-25".
std::string manual(const CLI::App& program, const std::string& version, const std::string& date);

}  // namespace plumb::app
