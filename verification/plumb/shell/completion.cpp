#include "verification/plumb/shell/completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "verification/plumb/usage.hpp"

namespace plumb::app {
namespace {

/// 'text' for a shell, whatever is in it.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " " + b;
}

/// "--json --csv": the options of the app that are not meant by their place.
std::string option_words(const CLI::App& app, bool only_with_value) {
  std::string words;
  for (const CLI::Option* option : app.get_options())
    if (!only_with_value || takes_value(*option))
      for (const auto& name : option->get_lnames()) words += (words.empty() ? "--" : " --") + name;
  return words;
}

std::string command_words(const CLI::App& app) {
  std::string words;
  for (const auto& name : command_names(app)) words += (words.empty() ? "" : " ") + name;
  return words;
}

/// One entry of _arguments or _describe: colons and brackets have a meaning there.
std::string described(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_function(const std::string& words) {
  std::string name = "_plumb";
  for (const char c : words) name += c == ' ' ? '_' : c;
  return words.empty() ? name : name.insert(6, "_");
}

/// The function that completes one subcommand: its members, or its options and files.
std::string zsh_completes(const std::string& words, const CLI::App& app) {
  std::string text = zsh_function(words) + "() {\n";
  std::string options;
  for (const CLI::Option* option : app.get_options())
    for (const auto& name : option->get_lnames())
      options +=
          fmt::format(" \\\n    {}", quoted(fmt::format("{}--{}[{}]{}", takes_value(*option) ? "*" : "", name,
                                                        described(option->get_description()),
                                                        takes_value(*option) ? ":value:_files" : "")));
  const auto members = app.get_subcommands([](const CLI::App*) { return true; });
  if (members.empty()) return text + "  _arguments" + options + " \\\n    '*:file:_files'\n}\n";
  text += "  local state line\n  _arguments -C" + options +
          " \\\n    '1:command:->command' \\\n    '*::argument:->argument'\n"
          "  case $state in\n    command)\n      local -a members=(";
  for (const CLI::App* member : members)
    text += "\n        " + quoted(described(member->get_name()) + ":" + described(member->get_description()));
  text += ")\n      _describe command members ;;\n    argument)\n      case $line[1] in\n";
  for (const CLI::App* member : members)
    text += fmt::format("        {}) {} ;;\n", member->get_name(),
                        zsh_function(words.empty() ? member->get_name() : words + " " + member->get_name()));
  return text + "      esac ;;\n  esac\n}\n";
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string members, words, values;
  words += fmt::format("    '') words={} ;;\n",
                       quoted(joined(command_words(program), option_words(program, false))));
  for (const auto& [path, app] : every_command(program)) {
    members += (members.empty() ? "" : " | ") + quoted(" " + path);
    words += fmt::format("    {}) words={} ;;\n", quoted(" " + path),
                         quoted(joined(command_words(*app), option_words(*app, false))));
    if (const auto taking = option_words(*app, true); !taking.empty())
      values += fmt::format("    {}) values={} ;;\n", quoted(" " + path), quoted(" " + taking + " "));
  }
  return fmt::format(R"(# Completion of plumb in bash. Made by `plumb completion bash`: do not edit.
_plumb() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} path= words= values= i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do  # the subcommand so far
    case "$path ${{COMP_WORDS[i]}}" in
      {}) path+=" ${{COMP_WORDS[i]}}" ;;
    esac
  done
  case $path in
{}  esac
  case $path in
{}  esac
  [[ $values == *" $previous "* ]] && return  # its value: a file, as far as can be known
  if [[ $word == -* || $words != -* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  fi
}}
complete -o default -F _plumb plumb
)",
                     members, words, values);
}

std::string zsh_completion(const CLI::App& program) {
  std::string text =
      "#compdef plumb\n# Completion of plumb in zsh. Made by `plumb completion zsh`: do not edit.\n";
  for (const auto& [path, app] : every_command(program)) text += zsh_completes(path, *app);
  return text + zsh_completes("", program) + "_plumb \"$@\"\n";
}

}  // namespace plumb::app
