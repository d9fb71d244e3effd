#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Describes a program of subcommands.
struct Program {
  std::string name;         ///< "plumb"
  std::string description;  ///< "Plumbline: .."
  void (*add_commands)(CLI::App& program, Session& session);
  /// Looks at the words before they are parsed, and may become another program.
  void (*hand_over)(const std::vector<std::string>& words, char** arguments) = nullptr;
};

/// Runs the program on its arguments; returns the exit code. Every error is said, and written as JSON where
/// that is asked for.
int run_program(const Program& program, int count, char** arguments);

/// Finds another program of this build: the one of that name in the folder of the program that runs.
std::optional<std::filesystem::path> program_beside(const std::string& name);

/// Finds `plumb` beside this program, to call its commands. Throws InputError if it is not there.
std::filesystem::path required_program();

}  // namespace plumb::app
