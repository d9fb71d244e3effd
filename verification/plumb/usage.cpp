#include "verification/plumb/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "lib/core/error.hpp"
#include "verification/plumb/hand_over.hpp"

namespace plumb::app {
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
  path = program.get_name();
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

/// Names of the subcommands right below, and of those that are handed over.
std::vector<std::string> callable_names(const CLI::App& app) {
  auto names = command_names(app);
  if (app.get_name() == "plumb")
    for (auto& name : house_words()) names.push_back(std::move(name));
  return names;
}

std::string unexpected(const CLI::App& app, const std::string& path, const std::string& argument) {
  if (argument.size() > 1 && argument[0] == '-')
    return unknown_name("option", argument.substr(0, argument.find('=')), option_names(app)).what();
  const auto commands = callable_names(app);
  if (!commands.empty()) return unknown_name("command", argument, commands).what();
  return sentences(fmt::format("unexpected argument \"{}\"", argument), "",
                   fmt::format("see {} --help", path));
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(any)) names.push_back(command->get_name());
  return names;
}

std::vector<std::pair<std::string, std::string>> first_calls() {
  return {{"plumb new scene first.toml", "writes a small scene, every setting explained in it"},
          {"plumb explain first.toml", "what it solves, with which equations, and what that costs"},
          {"plumb run first.toml", "runs it: energies, momenta, particles for ParaView"},
          {"plumb oned", "the explorer of kernel corrections in 1D: a page to play with"},
          {"plumb mms --check swinging-plate", "a manufactured solution, its loads derived twice"},
          {"plumb list", "what scenes can name: kernels, gradients, materials .., and scenes to start from"}};
}

std::string example_of(const CLI::App& app) {
  const std::string footer = app.get_footer(), start = "Example: ";
  return footer.starts_with(start) ? footer.substr(start.size(), footer.find('\n') - start.size()) : "";
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

std::vector<CommandPath> every_command(const CLI::App& program) {
  std::vector<CommandPath> all;
  for (const CLI::App* command : program.get_subcommands(any)) {
    all.push_back({command->get_name(), command});
    for (const auto& [words, app] : every_command(*command))
      all.push_back({command->get_name() + " " + words, app});
  }
  return all;
}

namespace {

/// Who a command is for.
enum class Group { first, study, house };

Group group_of(const std::string& command) {
  const auto is_one_of = [&command](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), command) != names.end();
  };
  if (is_one_of({"new", "explain", "run", "list", "oned", "mms", "judge"})) return Group::first;
  if (is_one_of({"bench", "claims", "completion", "faults", "manual", "refusals"})) return Group::house;
  return Group::study;
}

}  // namespace

std::string first_steps(const CLI::App& program) {
  const bool house = program.get_name() != "plumb";
  std::string text = program.get_description() + "\n";
  if (!house) text += "\nTry first:\n";
  if (!house)
    for (const auto& [line, meaning] : first_calls()) text += fmt::format("  {}\n      {}\n", line, meaning);
  std::size_t width = 0;
  for (const auto& name : command_names(program)) width = std::max(width, name.size());
  for (const auto& [heading, group] :
       {std::pair("Commands", Group::first), std::pair("Commands for studies", Group::study),
        std::pair("Commands about Plumbline itself", Group::house)}) {
    if (house && group != Group::house) continue;
    text += fmt::format("\n{}:\n", heading);
    for (const CLI::App* command : program.get_subcommands(any))
      if (group_of(command->get_name()) == group)
        text += fmt::format("  {:<{}}  {}\n", command->get_name(), width, command->get_description());
  }
  if (!house)
    text += "\nplumb-house has the commands that check Plumbline itself: " + join(house_words()) + ".\n";
  return text + fmt::format(
                    "\n{0} help COMMAND explains one, with an example; {0} manual | man -l - explains all.\n"
                    "{0} --version says what this build is.\n",
                    program.get_name());
}

std::string shell_line(const std::vector<std::string>& arguments, const std::string& program) {
  std::string line = program;
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

std::vector<std::string> with_help_option(const CLI::App& program, std::vector<std::string> arguments) {
  const CLI::App* app = &program;
  bool asked = false;
  std::vector<std::string> words;
  for (const auto& argument : arguments) {
    const auto commands = command_names(*app);
    if (commands.empty()) break;
    if (!asked && argument == "help") {
      asked = true;
      continue;
    }
    if (std::find(commands.begin(), commands.end(), argument) == commands.end()) {
      if (asked) throw unknown_name("command", argument, callable_names(*app));
      break;
    }
    words.push_back(argument);
    app = app->get_subcommand(argument);
  }
  if (!asked) return arguments;
  if (!words.empty()) words.emplace_back("--help");
  return words;
}

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
  std::string path;
  const CLI::App* app = culprit(program, path);
  const auto left = app->remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !left.empty())
    return fmt::format("{}: {}", path, unexpected(*app, path, left.front()));
  return sentences(fmt::format("{}: {}", path, error.what()), "", fmt::format("see {} --help", path));
}

}  // namespace plumb::app
