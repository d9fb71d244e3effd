#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/commands.hpp"
#include "plumb/data_folder.hpp"
#include "plumb/parts.hpp"
#include "plumb/session.hpp"
#include "plumbline/material/law.hpp"

namespace plumb {
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
  for (const auto& [kind, plural] : {std::pair("kernel", "kernels"),
                                     {"gradient", "gradients"},
                                     {"momentum", "momenta"},
                                     {"integrator", "integrators"},
                                     {"material", "materials"}}) {
    names[plural] = Json::array();
    for (const Part& part : parts) {
      if (part.kind != kind) continue;
      names[plural].push_back(part.name);
      rows.push_back(
          {{"kind", kind}, {"name", part.name}, {"meaning", part.meaning}, {"theory", part.theory}});
      if (part.kind == "material") rows.back()["parameters"] = parameters_json(part.name);
    }
  }
  const auto folder = data_folder() / "verification" / "scenes";
  names["parts"] = rows;
  names["scenes"] = scenes_in(folder);
  return names;
}

void tell(std::ostream& out, const Json& json) {
  std::string kind;
  for (const auto& part : json["parts"]) {
    if (part["kind"] != kind) out << (kind.empty() ? "" : "\n") << part["kind"].get<std::string>() << ":\n";
    kind = part["kind"];
    const std::string theory = part["theory"];
    out << fmt::format("  {:<14} {}{}\n", part["name"].get<std::string>(), part["meaning"].get<std::string>(),
                       theory.empty() ? "" : ". " + theory);
    if (!part.contains("parameters")) continue;
    for (const auto& about : part["parameters"]) {
      const std::string unit = about["unit"];
      out << fmt::format("  {:<14}   {}{}: {}{}\n", "", about["name"].get<std::string>(),
                         unit.empty() ? "" : " [" + unit + "]", about["meaning"].get<std::string>(),
                         about["required"].get<bool>() ? ", required" : "");
    }
  }
  if (json["scenes"].empty()) return;
  const std::filesystem::path first = json["scenes"][0]["file"].get<std::string>();
  out << "\nscenes in " << first.parent_path().string() << ":\n";
  for (const auto& scene : json["scenes"])
    out << fmt::format("  {:<30} {}\n", scene["name"].get<std::string>(), scene["shows"].get<std::string>());
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
  add_command(
      program, session,
      {"list", "kernels, gradients, materials .. that can be named, and the scenes at hand", "plumb list"},
      {}, action);
}

}  // namespace plumb
