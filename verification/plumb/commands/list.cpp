#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/output/listed.hpp"
#include "lib/output/terminal.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/data_folder.hpp"
#include "verification/plumb/named_parts.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

/// A scene at hand.
struct ListedScene {
  std::string name, file, shows;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("name", self.name);
    visit("file", self.file);
    visit("shows", self.shows);
  }
};

std::vector<ListedScene> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<ListedScene> scenes;
  for (const auto& file : files) scenes.push_back({file.stem().string(), file.string(), what_it_shows(file)});
  return scenes;
}

/// "boundary kind" as a key of the JSON: "boundary_kinds".
std::string plural_key(std::string kind) {
  if (kind == "momentum") return "momenta";
  for (char& c : kind)
    if (c == ' ') c = '_';
  return kind + "s";
}

/// Names by kind, "kernels": [..], "parts" with what is known of each, and the scenes.
nlohmann::ordered_json json_of(const std::vector<NamedPart>& parts, const std::vector<ListedScene>& scenes) {
  auto json = nlohmann::ordered_json::object();
  for (const NamedPart& part : parts) json[plural_key(part.kind)].push_back(part.name);
  json["parts"] = to_json(parts);
  for (auto& row : json["parts"])
    if (row["parameters"].is_null()) row.erase("parameters");  // only materials have any
  json["scenes"] = to_json(scenes);
  return json;
}

void tell_parameters(std::ostream& out, const std::vector<NamedParameter>& parameters, std::size_t indent) {
  const auto columns = static_cast<std::size_t>(terminal_columns(1));
  for (const NamedParameter& about : parameters) {
    const std::string text =
        fmt::format("{}{}: {}{}", about.name, about.unit.empty() ? "" : " [" + about.unit + "]",
                    about.meaning, about.required ? ", required" : "");
    out << fmt::format("{:{}}{}\n", "", indent + 2, wrapped(text, columns, indent + 2, indent + 4));
  }
}

void tell(std::ostream& out, const std::vector<NamedPart>& parts, const std::vector<ListedScene>& scenes) {
  constexpr std::size_t indent = 18;
  const auto columns = static_cast<std::size_t>(terminal_columns(1));
  std::string kind;
  for (const NamedPart& part : parts) {
    if (part.kind != kind) out << fmt::format("{}{} ({}):\n", kind.empty() ? "" : "\n", part.kind, part.key);
    kind = part.kind;
    const std::string said = part.meaning + (part.theory.empty() ? "" : ". " + part.theory);
    out << fmt::format("  {:<15} {}\n", part.name,
                       wrapped(said, columns, std::max(indent, part.name.size() + 3), indent));
    if (part.parameters) tell_parameters(out, *part.parameters, indent);
  }
  if (scenes.empty()) return;
  out << "\nscenes in " << std::filesystem::path(scenes.front().file).parent_path().string() << ":\n";
  for (const ListedScene& scene : scenes)
    out << fmt::format("  {}\n      {}\n", scene.name, wrapped(scene.shows, columns, 6, 6));
}

}  // namespace

/// `plumb list`: the parts that scenes and options can name, and the scenes that are there.
void add_list(CLI::App& program, Session& session) {
  const auto action = [&session] {
    const auto parts = named_parts();
    const auto scenes = scenes_in(data_folder() / "verification" / "scenes");
    tell(session.text(), parts, scenes);
    session.write_json(json_of(parts, scenes));
    return 0;
  };
  add_command(program, session,
              {"list", "what scenes, studies and options can name, and the scenes at hand", "plumb list"}, {},
              action);
}

}  // namespace plumb::app
