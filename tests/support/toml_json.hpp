#pragma once
#include <nlohmann/json.hpp>

#include "lib/input/document.hpp"

namespace plumb::test {

/// Converts a TOML document to JSON, as editors do before they check it against a schema.
inline nlohmann::json json_of(const TomlValue& value) {
  nlohmann::json json;
  switch (value.kind) {
    case TomlValue::Kind::boolean:
      return value.flag;
    case TomlValue::Kind::integer:
      return value.whole;
    case TomlValue::Kind::real:
      return value.number;
    case TomlValue::Kind::array:
      json = nlohmann::json::array();
      for (const TomlValue& item : value.items) json.push_back(json_of(item));
      return json;
    case TomlValue::Kind::table:
      json = nlohmann::json::object();
      for (std::size_t k = 0; k < value.names.size(); ++k) json[value.names[k]] = json_of(value.items[k]);
      return json;
    default:
      return value.text;
  }
}

}  // namespace plumb::test
