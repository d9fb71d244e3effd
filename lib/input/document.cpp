#include "lib/input/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "lib/input/spelling.hpp"

namespace plumb {
namespace {

constexpr const char* override_file = "--set";

TomlValue converted(const toml::node& node, const std::string& file) {
  TomlValue value;
  value.where = {file, file == override_file ? 0 : static_cast<long>(node.source().begin.line)};
  if (const auto* flag = node.as_boolean()) {
    value.kind = TomlValue::Kind::boolean;
    value.flag = flag->get();
  } else if (const auto* whole = node.as_integer()) {
    value.kind = TomlValue::Kind::integer;
    value.whole = whole->get();
    value.number = static_cast<double>(whole->get());
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = TomlValue::Kind::real;
    value.number = number->get();
  } else if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::text;
    value.text = text->get();
  } else if (const auto* array = node.as_array()) {
    value.kind = TomlValue::Kind::array;
    for (const auto& item : *array) value.items.push_back(converted(item, file));
  } else if (const auto* table = node.as_table()) {
    value.kind = TomlValue::Kind::table;
    std::vector<std::pair<const toml::node*, std::string>> entries;
    for (const auto& [key, item] : *table) entries.emplace_back(&item, std::string(key.str()));
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
      return a.first->source().begin.line < b.first->source().begin.line;
    });
    for (const auto& [item, name] : entries) {
      value.names.push_back(name);
      value.items.push_back(converted(*item, file));
    }
  } else {
    value.kind = TomlValue::Kind::other;  // dates and times
  }
  return value;
}

/// Numbers that TOML takes with another digit only: .5, -.5e3 and 5. but not 004, which is a name.
std::optional<double> without_a_digit(const std::string& text) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (text.size() < first + 2 || (text[first] != '.' && text.back() != '.')) return {};
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

/// The value after "=": as TOML if it is that, .5 and 5. as the numbers they are, else as bare text.
TomlValue override_value(const std::string& text) {
  try {
    const toml::table parsed = toml::parse("v = " + text);
    if (parsed.size() == 1) return converted(*parsed.get("v"), override_file);
  } catch (const toml::parse_error&) {  // not TOML: bare text, such as 17 MPa or verlet
  }
  TomlValue value;
  value.where = {override_file, 0};
  if (const auto number = without_a_digit(text)) {
    value.kind = TomlValue::Kind::real;
    value.number = *number;
  } else {
    value.kind = TomlValue::Kind::text;
    value.text = text;
  }
  return value;
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  if (path.empty() || path.back() == '.') parts.emplace_back();
  return parts;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\n\r") - first + 1);
}

TomlValue& item_of_array(TomlValue& array, const std::string& part, const std::string& path) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  const bool counted = error == std::errc{} && end == part.data() + part.size();
  if (counted && index < array.items.size()) return array.items[index];
  const auto at = path.rfind("." + part);
  const std::string numbered = at == std::string::npos ? "" : path.substr(0, at) + ".0" + path.substr(at);
  throw SceneError({override_file, 0}, path, fmt::format("no item \"{}\"", part),
                   fmt::format("the scene has {} there, counted from 0", array.items.size()),
                   counted || array.items.empty() ? "" : fmt::format("write {}", numbered));
}

/// The table entry `name`, made as an empty table if it is not there.
TomlValue& entry_of_table(TomlValue& table, const std::string& name) {
  if (TomlValue* found = table.find(name)) return *found;
  table.names.push_back(name);
  table.items.emplace_back();
  table.items.back().where = {override_file, 0};
  return table.items.back();
}

void drop_alternatives(TomlValue& section, const std::string& path, const Alternatives& alternatives,
                       const std::vector<std::string>& overridden) {
  const auto dot = path.rfind('.');
  for (const auto& group : alternatives) {
    if (std::find(group.begin(), group.end(), path) == group.end()) continue;
    for (const auto& other : group) {
      if (other == path || std::find(overridden.begin(), overridden.end(), other) != overridden.end())
        continue;
      const auto found = std::find(section.names.begin(), section.names.end(), other.substr(dot + 1));
      if (found == section.names.end()) continue;
      section.items.erase(section.items.begin() + (found - section.names.begin()));
      section.names.erase(found);
    }
  }
}

/// A value that is neither array nor table, without ends of line and tabs.
std::string short_text(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::boolean:
      return value.flag ? "true" : "false";
    case TomlValue::Kind::integer:
      return std::to_string(value.whole);
    case TomlValue::Kind::real:
      return fmt::format("{:.17g}", value.number);
    default:
      break;
  }
  std::string text = value.text;
  for (char& c : text)
    if (c == '\t' || c == '\n') c = ' ';
  return "\"" + text + "\"";
}

void add_settings(const TomlValue& value, const std::string& key,
                  std::map<std::string, std::string>& settings) {
  const bool table = value.is(TomlValue::Kind::table);
  if (!table && !value.is(TomlValue::Kind::array)) {
    settings[key] = short_text(value);
    return;
  }
  if (value.items.empty()) settings[key] = table ? "{}" : "[]";
  for (std::size_t k = 0; k < value.items.size(); ++k)
    add_settings(value.items[k],
                 key + (key.empty() ? "" : ".") + (table ? value.names[k] : std::to_string(k)), settings);
}

/// Applies one "section.key=value"; returns its path.
std::string apply_override(TomlValue& root, const std::string& text, const Alternatives& alternatives,
                           const std::vector<std::string>& overridden) {
  const auto equals = text.find('=');
  std::string path = trimmed(text.substr(0, equals));
  const std::vector<std::string> parts = split(path);
  const bool complete = equals != std::string::npos && parts.size() > 1 &&
                        std::none_of(parts.begin(), parts.end(), [](const auto& p) { return p.empty(); });
  const std::string bare = equals == std::string::npos ? "" : trimmed(text.substr(equals + 1));
  if (!complete || bare.empty())
    throw SceneError({override_file, 0}, "", fmt::format("\"{}\" is not an override", text),
                     "it must read section.key=value", "write for example --set material.young=\"17 MPa\"");
  TomlValue* section = &root;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    TomlValue& next = section->is(TomlValue::Kind::array) ? item_of_array(*section, parts[k], path)
                                                          : entry_of_table(*section, parts[k]);
    if (!next.is(TomlValue::Kind::table) && !next.is(TomlValue::Kind::array))
      throw SceneError({override_file, 0}, path, fmt::format("\"{}\" is not a section", parts[k]),
                       "it is " + description_of(next) + " at " + text_of(next.where), "");
    section = &next;
  }
  const bool in_array = section->is(TomlValue::Kind::array);
  TomlValue& target =
      in_array ? item_of_array(*section, parts.back(), path) : entry_of_table(*section, parts.back());
  target = override_value(bare);
  if (!in_array) drop_alternatives(*section, path, alternatives, overridden);
  return path;
}

}  // namespace

const TomlValue* TomlValue::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &items[static_cast<std::size_t>(found - names.begin())];
}

TomlValue* TomlValue::find(const std::string& name) {
  return const_cast<TomlValue*>(static_cast<const TomlValue&>(*this).find(name));
}

std::string description_of(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::boolean:
      return value.flag ? "true" : "false";
    case TomlValue::Kind::integer:
      return fmt::format("the number {}", value.whole);
    case TomlValue::Kind::real:
      return fmt::format("the number {}", value.number);
    case TomlValue::Kind::text:
      return fmt::format("the string \"{}\"", value.text);
    case TomlValue::Kind::array:
      return "an array";
    case TomlValue::Kind::table:
      return "a section";
    case TomlValue::Kind::other:
      break;
  }
  return "a date or time";
}

TomlValue parse_document(const std::string& text, const std::string& file_name,
                         const std::vector<std::string>& overrides, const Alternatives& alternatives) {
  TomlValue root;
  try {
    root = converted(toml::parse(text), file_name);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw SceneError({file_name, static_cast<long>(at.line)}, "",
                     fmt::format("not valid TOML at column {}", at.column), std::string(error.description()),
                     hint_at_decimal_comma(text, static_cast<std::size_t>(at.line)));
  }
  root.where.line = 0;
  std::vector<std::string> overridden;
  overridden.reserve(overrides.size());
  for (const auto& change : overrides)
    overridden.push_back(apply_override(root, change, alternatives, overridden));
  return root;
}

std::map<std::string, std::string> settings_of(const TomlValue& document) {
  std::map<std::string, std::string> settings;
  add_settings(document, "", settings);
  return settings;
}

std::string read_text(const std::string& path) {
  if (std::filesystem::is_directory(path))
    throw SceneError({path, 0}, "", "cannot be read", "it is a folder", "give the name of a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw SceneError({path, 0}, "", "cannot be read", std::strerror(errno), "check the name");
  return text.str();
}

}  // namespace plumb
