#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace plumb {

/// What `plumb` alone prints: what to try first.
std::string first_steps(const CLI::App& program);

/// The arguments as one line that a shell takes back, with "plumb" for the program.
std::string shell_line(const std::vector<std::string>& arguments);

/// The message for a command line that cannot be parsed: names the nearest valid option or subcommand.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace plumb
