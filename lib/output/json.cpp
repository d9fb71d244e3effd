#include "lib/output/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of_value(double value) {
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

void clean_object(Json& object);

/// Cleans one value; what was not finite in it, and belongs to the enclosing object, is appended to `found`.
void clean(Json& value, const std::string& path, std::string& found) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    found += (found.empty() ? "" : ", ") + path + " (" + name_of_value(value.get<double>()) + ")";
    value = nullptr;
  } else if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k)
      clean(value[k], path + "[" + std::to_string(k) + "]", found);
  } else if (value.is_object()) {
    clean_object(value);
  }
}

void clean_object(Json& object) {
  std::string found;
  for (auto& item : object.items()) clean(item.value(), item.key(), found);
  if (found.empty()) return;
  if (object.contains("status"))
    object["not_finite"] = found;
  else
    object["status"] = "not finite: " + found;
}

}  // namespace

Json with_finite_numbers(Json value) {
  std::string outside;
  clean(value, "value", outside);
  return value;
}

std::string json_text(const Json& value) {
  return with_finite_numbers(value).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumb
