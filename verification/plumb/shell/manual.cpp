#include "verification/plumb/shell/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <set>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/words.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/usage.hpp"

namespace plumb::app {
namespace {

/// Text that roff takes as it stands: backslashes, hyphens that may be copied, no control characters at the
/// start of a line.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\n')
      result += "\n\\&";
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}

/// "--json FILE", "--resume", "SCENE".
std::string option_head(const CLI::Option& option) {
  std::string names;
  for (const auto& name : option.get_snames()) names += (names.empty() ? "" : ", ") + bold("-" + name);
  for (const auto& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + bold("--" + name);
  if (option.get_positional()) names = bold(option.get_name(true));
  if (takes_value(option) && !option.get_positional())
    names += " \\fI" + plain(option.get_type_name()) + "\\fR";
  return names;
}

std::string option_entry(const CLI::Option& option) {
  std::string text = option.get_description();
  if (!option.get_default_str().empty()) text += fmt::format(" (default: {})", option.get_default_str());
  if (option.get_required()) text += " (required)";
  return fmt::format(".TP\n{}\n{}\n", option_head(option), plain(text));
}

std::string command_entry(const std::string& program, const std::string& path, const CLI::App& app) {
  std::string text =
      fmt::format(".SS {}\n{}\n", plain(program + " " + path), plain(app.get_description()) + ".");
  for (const CLI::Option* option : app.get_options())
    if (option != app.get_help_ptr() && option->get_group() != shared_options) text += option_entry(*option);
  if (const auto example = example_of(app); !example.empty())
    text += ".PP\nExample:\n.PP\n.nf\n.RS\n" + plain(example) + "\n.RE\n.fi\n";
  return text;
}

/// The options of --json and so on, each once.
std::string shared_entries(const CLI::App& program) {
  std::string text;
  std::set<std::string> seen;
  for (const auto& [path, app] : every_command(program))
    for (const CLI::Option* option : app->get_options())
      if (option->get_group() == shared_options && seen.insert(option->get_name()).second)
        text += option_entry(*option);
  return text;
}

}  // namespace

std::string manual(const CLI::App& program, const std::string& version, const std::string& date) {
  const std::string name = program.get_name(), description = program.get_description();
  std::string title = name;
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string text =
      fmt::format(".\\\" Made by `{} manual`: do not edit.\n.TH {} 1 \"{}\" \"Plumbline {}\"\n.SH NAME\n",
                  name, plain(title), date, version);
  text += plain(name) + " \\- " + plain(description.substr(description.find(": ") + 2)) + "\n";
  text += ".SH SYNOPSIS\n" + bold(name) + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n";
  if (name == "plumb") {
    text += ".SH FIRST STEPS\n.nf\n";
    for (const auto& [line, meaning] : first_calls()) text += plain(line) + "\n    " + plain(meaning) + "\n";
    text += ".fi\n";
  }
  text += ".SH OPTIONS OF ALL COMMANDS\nTables and pictures only where a command makes them.\n" +
          shared_entries(program);
  text += ".SH COMMANDS\n" + plain(where_examples_run) + "\n";
  for (const auto& [path, app] : every_command(program)) text += command_entry(name, path, *app);
  text += ".SH VERDICTS\n";
  for (const VerdictWord& one : verdict_words)
    text += fmt::format(".TP\n{}\n{}\n", bold(std::string(one.word)), plain(std::string(one.meaning)));
  text += ".PP\n" + plain(std::string(norms_explained)) + "\n";
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_codes)
    text += fmt::format(".TP\n{}\n{}\n", bold(std::to_string(code)), plain(meaning));
  return text;
}

}  // namespace plumb::app
