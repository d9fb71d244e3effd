#include "verification/plumb/keys/key_schema.hpp"

#include <nlohmann/json.hpp>

#include "lib/input/document.hpp"
#include "verification/plumb/keys/key_words.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// A number, or one with its unit as a string.
Json number_schema(Sign sign) {
  Json number{{"type", "number"}};
  if (sign == Sign::positive) number["exclusiveMinimum"] = 0;
  if (sign == Sign::not_negative) number["minimum"] = 0;
  const Json measured{{"type", "string"}, {"pattern", "^\\s*[-+]?\\.?[0-9]"}};
  return {{"anyOf", Json::array({number, measured})}};
}

Json formula_schema() {
  return {{"type", Json::array({"number", "string"})}};
}

/// An array; of `count` entries unless that is 0.
Json array_of(const Json& entry, std::size_t count) {
  Json array{{"type", "array"}, {"items", entry}, {"minItems", std::max<std::size_t>(count, 1)}};
  if (count > 0) array["maxItems"] = count;
  return array;
}

Json section_schema(const KeyNotes& notes, const std::string& path);

Json value_schema(const KeyNotes& notes, const std::string& path, const ValueForm& form) {
  const Json whole{{"type", "integer"}, {"minimum", form.least}}, text{{"type", "string"}, {"minLength", 1}},
      word{{"type", "string"}, {"enum", form.words}};
  switch (form.kind) {
    case ValueKind::number:
      return number_schema(form.sign);
    case ValueKind::any_number:
      return number_schema(Sign::any);
    case ValueKind::integer:
      return whole;
    case ValueKind::flag:
      return {{"type", "boolean"}};
    case ValueKind::text:
      return text;
    case ValueKind::choice:
      return word;
    case ValueKind::numbers:
      return array_of(number_schema(form.sign), form.count);
    case ValueKind::points: {
      const Json number = number_schema(Sign::any);
      return array_of({{"anyOf", Json::array({number, array_of(number, form.count)})}}, 0);
    }
    case ValueKind::integers:
      return array_of(whole, form.count);
    case ValueKind::texts:
      return array_of({{"type", Json::array({"string", "number"})}}, form.count);
    case ValueKind::choices:
      return array_of(word, 0);
    case ValueKind::formula:
      return formula_schema();
    case ValueKind::formulas:
      return array_of(formula_schema(), form.count);
    case ValueKind::number_rows:
      return array_of(array_of(number_schema(Sign::any), 0), 0);
    case ValueKind::formula_rows:
      return array_of(array_of(formula_schema(), 0), 0);
    case ValueKind::section:
      return section_schema(notes, path);
    case ValueKind::sections:
      return {{"type", "array"}, {"items", section_schema(notes, path + ".0")}};
  }
  return {};
}

/// A default as JSON.
Json json_of(const std::string& toml) {
  const TomlValue value = *parse_document("v = " + toml, "default").find("v");
  if (value.is(TomlValue::Kind::boolean)) return value.flag;
  if (value.is(TomlValue::Kind::integer)) return value.whole;
  if (value.is(TomlValue::Kind::real)) return value.number;
  return value.text;
}

Json key_schema(const KeyNotes& notes, const KeyNote& key) {
  Json schema;
  Json forms = Json::array();
  for (const ValueForm& form : key.forms) forms.push_back(value_schema(notes, key.path, form));
  schema = forms.size() == 1 ? forms.front() : Json{{"anyOf", forms}};
  const std::string unit = unit_of(key);
  schema["description"] = key.meaning + (unit.empty() ? "" : " [" + unit + "]") + default_in_words(key, "; ");
  if (key.otherwise.size() == 1) schema["default"] = json_of(*key.otherwise.begin());
  return schema;
}

Json section_schema(const KeyNotes& notes, const std::string& path) {
  Json schema{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
  Json required = Json::array();
  for (const KeyNote* key : keys_in(notes, path)) {
    const std::string name = last_part(key->path);
    if (name == "*")
      schema["additionalProperties"] = key_schema(notes, *key);
    else
      schema["properties"][name] = key_schema(notes, *key);
    if (notes.required(*key)) required.push_back(name);
  }
  if (!required.empty()) schema["required"] = required;
  return schema;
}

}  // namespace

Json schema_of(const KeyNotes& notes, const std::string& title) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(section_schema(notes, ""));
  return schema;
}

}  // namespace plumb::app
