#pragma once
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumb::test {

/// A JSON document against a JSON schema (the words of draft 7 that verification/schema uses). An unknown
/// word of the schema is an error: it would check nothing.
class Schema {
 public:
  using Json = nlohmann::json;
  explicit Schema(Json root) : root_(std::move(root)) {}

  /// What does not fit, as "place: complaint"; empty if all does.
  std::vector<std::string> complaints(const Json& document) const { return check(document, root_, "$"); }

 private:
  using Complaints = std::vector<std::string>;

  static bool is(const Json& value, const std::string& type) {
    if (type == "null") return value.is_null();
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    throw std::runtime_error("schema: unknown type " + type);
  }
  static bool is_any(const Json& value, const Json& types) {
    if (types.is_string()) return is(value, types);
    for (const auto& type : types)
      if (is(value, type)) return true;
    return false;
  }

  /// The words that hold for one value without looking into it.
  static void check_value(const Json& value, const std::string& word, const Json& rule,
                          const std::string& place, Complaints& out) {
    const auto complain = [&](const std::string& what) { out.push_back(place + ": " + what); };
    if (word == "type" && !is_any(value, rule))
      complain(fmt::format("{} is no {}", value.dump(), rule.dump()));
    if (word == "const" && value != rule) complain(fmt::format("{} is not {}", value.dump(), rule.dump()));
    if (word == "enum" && std::find(rule.begin(), rule.end(), value) == rule.end())
      complain(fmt::format("{} is none of {}", value.dump(), rule.dump()));
    if (word == "minItems" && value.is_array() && value.size() < rule.get<std::size_t>())
      complain(fmt::format("{} entries", value.size()));
    if (word == "maxItems" && value.is_array() && value.size() > rule.get<std::size_t>())
      complain(fmt::format("{} entries", value.size()));
    if (word == "minLength" && value.is_string() && value.get<std::string>().size() < rule.get<std::size_t>())
      complain("the string is too short");
    if (word == "minimum" && value.is_number() && value < rule)
      complain(fmt::format("{} is less than {}", value.dump(), rule.dump()));
    if (word == "exclusiveMinimum" && value.is_number() && value <= rule)
      complain(fmt::format("{} is not more than {}", value.dump(), rule.dump()));
    if (word == "pattern" && value.is_string() &&
        !std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())))
      complain(fmt::format("{} does not match {}", value.dump(), rule.dump()));
    if (word == "required" && value.is_object())
      for (const auto& key : rule)
        if (!value.contains(key.get<std::string>())) complain("no " + key.dump());
  }

  Complaints check(const Json& value, const Json& schema, const std::string& place) const {
    static const std::set<std::string> known{
        "$schema",  "title",    "description", "$defs",   "if",
        "then",     "type",     "const",       "enum",    "minItems",
        "maxItems", "required", "minLength",   "minimum", "exclusiveMinimum",
        "pattern",  "default"};
    Complaints out;
    const auto add = [&out](const Complaints& more) { out.insert(out.end(), more.begin(), more.end()); };
    for (const auto& [word, rule] : schema.items()) {
      if (word == "$ref") {
        add(check(value, root_.at("$defs").at(rule.get<std::string>().substr(8)), place));
      } else if (word == "properties") {
        for (const auto& [key, part] : rule.items())
          if (value.is_object() && value.contains(key)) add(check(value.at(key), part, place + "." + key));
      } else if (word == "additionalProperties") {
        const Json none = Json::object(), &members = value.is_object() ? value : none;
        for (const auto& [key, part] : members.items()) {
          if (schema.contains("properties") && schema.at("properties").contains(key)) continue;
          if (rule.is_boolean() && !rule.get<bool>()) out.push_back(place + ": unknown key \"" + key + "\"");
          if (rule.is_object()) add(check(part, rule, place + "." + key));
        }
      } else if (word == "items") {
        for (std::size_t k = 0; value.is_array() && k < value.size(); ++k)
          add(check(value[k], rule, fmt::format("{}[{}]", place, k)));
      } else if (word == "allOf") {
        for (const auto& part : rule) add(check(value, part, place));
      } else if (word == "anyOf") {
        Complaints all;
        bool fits = false;
        for (const auto& part : rule) {
          const auto found = check(value, part, place);
          fits = fits || found.empty();
          all.insert(all.end(), found.begin(), found.end());
        }
        if (!fits) add(all);
      } else if (!known.contains(word)) {
        throw std::runtime_error("schema: unknown word " + word);
      } else {
        check_value(value, word, rule, place, out);
      }
    }
    if (schema.contains("if") && check(value, schema.at("if"), place).empty())
      add(check(value, schema.at("then"), place));
    return out;
  }

  Json root_;
};

}  // namespace plumb::test
