#include "verification/plumb/result.hpp"

#include <array>

#include "lib/input/scene_error.hpp"
#include "verification/plumb/provenance.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Names under which commands have their table.
constexpr std::array tables{"rows",      "levels", "points",    "faults", "claims",
                            "sentences", "parts",  "solutions", "modes"};

/// What every document begins with.
Json head(const Call& call, const std::string& kind, const std::string& status) {
  return {{"plumbline", version()}, {"command", call.command}, {"provenance", provenance()},
          {"kind", kind},           {"status", status},        {"exit_code", call.exit_code}};
}

/// Null for an empty text.
Json known(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

/// The problem without the place and the key in front of it.
std::string bare_problem(const SceneError& error) {
  const std::string place = text_of(error.where()) + ": " + (error.key().empty() ? "" : error.key() + ": ");
  return error.problem().starts_with(place) ? error.problem().substr(place.size()) : error.problem();
}

}  // namespace

std::string status_of(const Json& result, int exit_code) {
  const auto found = result.find("status");
  if (found != result.end() && found->is_string()) {
    const auto text = found->get<std::string>();
    if (text.find(' ') == std::string::npos) return text;
  }
  return exit_code == 0 ? "completed" : "fail";
}

Json document(const Json& result, const Call& call) {
  Json whole = head(call, call.kind, status_of(result, call.exit_code));
  for (const auto& [key, value] : result.items())
    if (key == "status") {
      if (value != whole["status"]) whole["reason"] = value;
    } else if (key != "kind" && key != "rows") {
      whole[key] = value;
    }
  whole["rows"] = Json::array();
  for (const char* table : tables)
    if (result.contains(table) && result.at(table).is_array()) {
      whole["rows"] = result.at(table);
      break;
    }
  return whole;
}

Json error_document(const std::exception& error, const Call& call) {
  Json whole = head(call, "error", "error");
  const auto* input = dynamic_cast<const InputError*>(&error);
  const auto* scene = dynamic_cast<const SceneError*>(&error);
  whole["problem"] = scene ? bare_problem(*scene) : input ? input->problem() : std::string(error.what());
  whole["why"] = known(input ? input->why() : "");
  whole["suggestion"] = known(input ? input->suggestion() : "");
  whole["file"] = known(scene ? scene->where().file : "");
  whole["line"] = scene && scene->where().line > 0 ? Json(scene->where().line) : Json();
  whole["key"] = known(scene ? scene->key() : "");
  whole["rows"] = Json::array();
  return whole;
}

std::string json_destination(const std::vector<std::string>& arguments) {
  const std::string option = "--json";
  std::string found;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == option && k + 1 < arguments.size()) found = arguments[k + 1];
    if (arguments[k].starts_with(option + "=")) found = arguments[k].substr(option.size() + 1);
  }
  return found;
}

}  // namespace plumb::app
