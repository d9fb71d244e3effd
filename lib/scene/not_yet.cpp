#include "plumbline/scene/not_yet.hpp"

#include <algorithm>
#include <array>

namespace plumb {
namespace {

constexpr std::array<std::string_view, 10> load_names{"load",       "loads",       "gravity", "traction",
                                                      "tractions",  "pressure",    "force",   "forces",
                                                      "body_force", "acceleration"};

bool is_load(std::string_view name) {
  return std::find(load_names.begin(), load_names.end(), name) != load_names.end();
}

void refuse_here(const Section& section, const TomlValue& table) {
  for (const auto& name : table.names) {
    const TomlValue& value = *table.find(name);
    const bool names_a_load = name == "kind" && value.is(TomlValue::Kind::text) && is_load(value.text);
    if (is_load(name) || names_a_load)
      section.fail(name, "loads do not exist in scenes yet",
                   "a body is moved by its initial velocity or spin and by its supports",
                   "use a manufactured solution, whose body force plumb mms derives");
  }
}

}  // namespace

void refuse_loads(const TomlValue& document) {
  refuse_here(Section(document, ""), document);
  for (const auto& name : document.names) {
    const TomlValue& value = *document.find(name);
    if (value.is(TomlValue::Kind::table)) refuse_here(Section(value, name), value);
    for (std::size_t k = 0; value.is(TomlValue::Kind::array) && k < value.items.size(); ++k)
      if (value.items[k].is(TomlValue::Kind::table))
        refuse_here(Section(value.items[k], name + "." + std::to_string(k)), value.items[k]);
  }
}

std::string no_time_yet(std::string_view name) {
  if (name != "t" && name != "T" && name != "time") return "";
  return "time does not exist in formulas yet: what they say holds for the whole run";
}

}  // namespace plumb
