#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/templates.hpp"

namespace plumb::app {
namespace {

/// The template with the name of the thing and of its file put in.
std::string filled(std::string_view text, const std::string& name, const std::string& file) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const auto put = [&](std::string_view mark, const std::string& value) {
      if (!rest.starts_with(mark)) return false;
      result += value;
      at += mark.size();
      return true;
    };
    if (put("@NAME@", name) || put("@FILE@", file)) continue;
    result += text[at++];
  }
  return result;
}

int write_new(const Session& session, const Template& kind, const std::string& wanted) {
  std::filesystem::path file = wanted;
  const std::string last = file.filename().string();
  if (last.empty() || last == "." || last == ".." || last == ".toml")
    throw InputError(fmt::format("\"{}\" names no file", wanted), "a scene and a study have a name",
                     "give one, such as first.toml");
  if (file.extension() != ".toml") file += ".toml";
  const std::string name = file.stem().string();
  if (name.find_first_of("\"\\\n@") != std::string::npos)
    throw InputError(fmt::format("\"{}\" cannot be a name", name),
                     "quotation marks, backslashes, line ends and @ have a meaning in the file",
                     "use letters, digits and hyphens");
  if (std::filesystem::exists(file))
    throw InputError(fmt::format("\"{}\" exists", file.string()), "it would be overwritten",
                     "choose another name or remove it");
  require_writable(file, "NAME");
  replace_file(file, filled(kind.text, name, file.string()));
  session.text() << fmt::format("wrote {}; its first lines say what to do next\n", file.string());
  session.write_json({{"file", file.string()}, {"kind", kind.name}});
  return 0;
}

}  // namespace

/// `plumb new scene|study NAME`: a commented file to start from. A further kind is one file in templates/.
void add_new(CLI::App& program, Session& session) {
  std::string kinds;
  for (const Template& kind : templates) kinds += (kinds.empty() ? "" : ", ") + std::string(kind.name);
  CLI::App& group = add_command_group(
      program, session,
      {"new", "writes a commented file to start from: " + kinds, "plumb new scene first.toml"});
  for (const Template& kind : templates) {
    const auto name = std::make_shared<std::string>();
    CLI::App& command = add_command(group, session,
                                    {std::string(kind.name), fmt::format("writes a commented {}", kind.name),
                                     fmt::format("plumb new {0} my-{0}.toml", kind.name)},
                                    {}, [&session, &kind, name] { return write_new(session, kind, *name); });
    command.add_option("NAME", *name, "the file to write; .toml is added if it is missing")
        ->required()
        ->type_name("FILE");
  }
}

}  // namespace plumb::app
