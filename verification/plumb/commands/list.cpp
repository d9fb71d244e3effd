#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/material/law.hpp"
#include "lib/output/terminal.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/data_folder.hpp"
#include "verification/plumb/named_parts.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Json scenes = Json::array();
  for (const auto& file : files)
    scenes.push_back(
        {{"name", file.stem().string()}, {"file", file.string()}, {"shows", what_it_shows(file)}});
  return scenes;
}

/// "boundary kind" as a key of the JSON: "boundary_kinds".
std::string plural_key(std::string kind) {
  if (kind == "momentum") return "momenta";
  for (char& c : kind)
    if (c == ' ') c = '_';
  return kind + "s";
}

/// The keys of [material] that a law has beside young, poisson and density.
Json parameters_json(std::string_view law) {
  Json all = Json::array();
  for (const LawParameter& about : parameters_of_law(law))
    all.push_back({{"name", about.name},
                   {"unit", about.quantity.unit},
                   {"meaning", about.meaning},
                   {"required", about.required}});
  return all;
}

/// Names by kind, "kernels": [..], and "parts" with what is known of each.
Json listed() {
  Json names = Json::object(), rows = Json::array();
  for (const NamedPart& part : named_parts()) {
    names[plural_key(part.kind)].push_back(part.name);
    rows.push_back({{"kind", part.kind},
                    {"key", part.key},
                    {"name", part.name},
                    {"meaning", part.meaning},
                    {"theory", part.theory}});
    if (part.kind == "material") rows.back()["parameters"] = parameters_json(part.name);
  }
  const auto folder = data_folder() / "verification" / "scenes";
  names["parts"] = rows;
  names["scenes"] = scenes_in(folder);
  return names;
}

void tell(std::ostream& out, const Json& json) {
  constexpr std::size_t indent = 18;
  const auto columns = static_cast<std::size_t>(terminal_columns(1));
  std::string kind;
  for (const auto& part : json["parts"]) {
    if (part["kind"] != kind)
      out << fmt::format("{}{} ({}):\n", kind.empty() ? "" : "\n", part["kind"].get<std::string>(),
                         part["key"].get<std::string>());
    kind = part["kind"];
    const std::string theory = part["theory"];
    const std::string said = part["meaning"].get<std::string>() + (theory.empty() ? "" : ". " + theory);
    const std::string name = part["name"];
    out << fmt::format("  {:<15} {}\n", name,
                       wrapped(said, columns, std::max(indent, name.size() + 3), indent));
    if (!part.contains("parameters")) continue;
    for (const auto& about : part["parameters"]) {
      const std::string unit = about["unit"];
      const std::string text =
          fmt::format("{}{}: {}{}", about["name"].get<std::string>(), unit.empty() ? "" : " [" + unit + "]",
                      about["meaning"].get<std::string>(), about["required"].get<bool>() ? ", required" : "");
      out << fmt::format("{:{}}{}\n", "", indent + 2, wrapped(text, columns, indent + 2, indent + 4));
    }
  }
  if (json["scenes"].empty()) return;
  const std::filesystem::path first = json["scenes"][0]["file"].get<std::string>();
  out << "\nscenes in " << first.parent_path().string() << ":\n";
  for (const auto& scene : json["scenes"])
    out << fmt::format("  {}\n      {}\n", scene["name"].get<std::string>(),
                       wrapped(scene["shows"].get<std::string>(), columns, 6, 6));
}

}  // namespace

/// `plumb list`: the parts that scenes and options can name, and the scenes that are there.
void add_list(CLI::App& program, Session& session) {
  const auto action = [&session] {
    const Json json = listed();
    tell(session.text(), json);
    session.write_json(json);
    return 0;
  };
  add_command(program, session,
              {"list", "what scenes, studies and options can name, and the scenes at hand", "plumb list"}, {},
              action);
}

}  // namespace plumb::app
