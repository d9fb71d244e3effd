#include "plumb/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

constexpr const char* plain_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";

bool any(const CLI::App*) {
  return true;
}

/// The app that an argument was left over in, or else the innermost one named; `path` becomes "plumb oned
/// study".
const CLI::App* culprit(const CLI::App& program, std::string& path) {
  const CLI::App* app = &program;
  path = "plumb";
  while (app->remaining().empty() && !app->get_subcommands().empty()) {
    app = app->get_subcommands().back();
    path += " " + app->get_name();
  }
  return app;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(any)) names.push_back(command->get_name());
  return names;
}

std::string unexpected(const CLI::App& app, const std::string& path, const std::string& argument) {
  if (argument.size() > 1 && argument[0] == '-')
    return unknown_name("option", argument.substr(0, argument.find('=')), option_names(app)).what();
  const auto commands = command_names(app);
  if (!commands.empty()) return unknown_name("command", argument, commands).what();
  return fmt::format("unexpected argument \"{}\", see {} --help", argument, path);
}

}  // namespace

std::string first_steps(const CLI::App& program) {
  std::string text = program.get_description() + "\n\nTry first:\n";
  std::size_t width = 0;
  for (const auto& name : command_names(program)) width = std::max(width, name.size());
  for (const CLI::App* command : program.get_subcommands(any)) {
    std::string example = command->get_footer();
    if (example.starts_with("Example: ")) text += "  " + example.substr(9) + "\n";
  }
  text += "\nCommands:\n";
  for (const CLI::App* command : program.get_subcommands(any))
    text += fmt::format("  {:<{}}  {}\n", command->get_name(), width, command->get_description());
  return text + "\nplumb COMMAND --help explains one; plumb --version says what this build is.\n";
}

std::string shell_line(const std::vector<std::string>& arguments) {
  std::string line = "plumb";
  for (const auto& argument : arguments) {
    if (!argument.empty() && argument.find_first_not_of(plain_characters) == std::string::npos) {
      line += " " + argument;
      continue;
    }
    line += " '";
    for (const char c : argument) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += "'";
  }
  return line;
}

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
  std::string path;
  const CLI::App* app = culprit(program, path);
  const auto left = app->remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !left.empty())
    return fmt::format("{}: {}", path, unexpected(*app, path, left.front()));
  return fmt::format("{}: {}, see {} --help", path, error.what(), path);
}

}  // namespace plumb
