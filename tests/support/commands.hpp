#pragma once
#include <fmt/format.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace plumb::test {

/// The names in the list of a help text, behind the heading.
inline std::vector<std::string> listed(const std::string& help, const std::string& heading) {
  std::vector<std::string> names;
  const auto start = help.find(heading);
  if (start == std::string::npos) return names;
  std::istringstream lines(help.substr(start + heading.size()));
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");)
    if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

/// All subcommands of a program as its help names them, "oned study" among them.
inline std::vector<std::string> commands_of(const std::string& program) {
  std::vector<std::string> all;
  const std::string help = run_shell(program).out;
  for (const char* heading :
       {"\nCommands:\n", "\nCommands for studies:\n", "\nCommands about Plumbline itself:\n"})
    for (const auto& name : listed(help, heading)) {
      all.push_back(name);
      for (const auto& member : listed(run_shell(program + " " + name + " --help").out, "Subcommands:\n"))
        all.push_back(fmt::format("{} {}", name, member));
    }
  return all;
}

/// All that `plumb` takes: its own, and those that it hands over to plumb-house.
inline std::vector<std::string> commands() {
  auto all = commands_of(PLUMB_EXECUTABLE);
  for (const auto& name : commands_of(PLUMB_EXECUTABLE "-house"))
    if (name != "manual") all.push_back(name);
  return all;
}

}  // namespace plumb::test
