#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "lib/core/error.hpp"

namespace plumb::app {

/// Adds the argument KIND to a command, one of `valid`; what it is by itself stands in `kind`.
inline void add_kind(CLI::App& command, const std::shared_ptr<std::string>& kind,
                     std::vector<std::string> valid) {
  command.add_option("KIND", *kind, "what is described: " + join(valid))
      ->check([valid](const std::string& given) {
        return std::find(valid.begin(), valid.end(), given) != valid.end()
                   ? std::string()
                   : std::string(unknown_name("kind of file", given, valid).what());
      })
      ->capture_default_str()
      ->type_name("KIND");
}

}  // namespace plumb::app
