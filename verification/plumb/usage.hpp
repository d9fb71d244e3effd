#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace plumb::app {

/// What the exit codes mean.
inline constexpr std::array<std::pair<int, const char*>, 3> exit_codes{{
    {0, "done"},
    {1, "a check failed or says nothing either way (the status tells which), or a run became unstable"},
    {2, "bad input: nothing was computed and nothing written, but for the error where --json asks for it"},
}};

inline constexpr const char* where_examples_run =
    "Files named verification/.. are in the source tree and in the folder "
    "share/plumbline of an installation; examples run from the folder that holds them.";

/// What to try first, in order: a line to copy and what it does. They need no file but those they make.
std::vector<std::pair<std::string, std::string>> first_calls();

/// A subcommand with the words that call it, as in "oned study".
struct CommandPath {
  std::string words;
  const CLI::App* app;
};

/// All subcommands, a group before its members, in the order of the help.
std::vector<CommandPath> every_command(const CLI::App& program);

/// Names of the subcommands right below.
std::vector<std::string> command_names(const CLI::App& app);

/// The copyable line of the help of a subcommand; empty if it has none.
std::string example_of(const CLI::App& app);

/// Whether a value follows the option; a flag has none.
bool takes_value(const CLI::Option& option);

/// What the program alone prints: what to try first, and its commands.
std::string first_steps(const CLI::App& program);

/// The arguments as one line that a shell takes back, behind the name of the program.
std::string shell_line(const std::vector<std::string>& arguments, const std::string& program = "plumb");

/// The arguments with the word "help" in the place of a subcommand put as --help behind what it is about:
/// "help oned study" and "oned help study" as "oned study --help"; "help" alone as nothing. Throws InputError
/// for a subcommand that is not there.
std::vector<std::string> with_help_option(const CLI::App& program, std::vector<std::string> arguments);

/// The message for a command line that cannot be parsed: names the nearest valid option or subcommand.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace plumb::app
