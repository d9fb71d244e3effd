#include "verification/plumb/keys/key_words.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"

namespace plumb::app {
namespace {

std::string section_of(const std::string& path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

bool is_section(const KeyNote& key, ValueKind kind) {
  for (const ValueForm& form : key.forms)
    if (form.kind == kind) return true;
  return false;
}

std::string bound_in_words(Sign sign) {
  return sign == Sign::positive ? ", positive" : sign == Sign::not_negative ? ", not negative" : "";
}

std::string number_in_words(const ValueForm& form) {
  const std::string name(form.quantity.name), unit(form.quantity.unit);
  const std::string in = unit.empty() || name.ends_with(" in " + unit) ? "" : " in " + unit;
  return (unit.empty() ? "a number" : name + in) + bound_in_words(form.sign);
}

std::string list_in_words(const std::string& of, const ValueForm& form) {
  return form.count > 0 ? fmt::format("[{} of them: {}]", form.count, of) : fmt::format("[a list: {}]", of);
}

std::string in_words(const ValueForm& form) {
  const std::string unit(form.quantity.unit), in = unit.empty() ? "" : " in " + unit;
  switch (form.kind) {
    case ValueKind::number:
      return number_in_words(form);
    case ValueKind::any_number:
      return "a number, with or without unit";
    case ValueKind::integer:
      return fmt::format("a whole number, at least {}", form.least);
    case ValueKind::flag:
      return "true or false";
    case ValueKind::text:
      return "a string";
    case ValueKind::choice:
      return join(form.words, " \\| ");
    case ValueKind::numbers:
      return list_in_words(number_in_words(form), form);
    case ValueKind::points:
      return list_in_words("points" + in, {});
    case ValueKind::integers:
      return list_in_words(fmt::format("whole numbers, at least {}", form.least), form);
    case ValueKind::texts:
      return "[a list of strings]";
    case ValueKind::choices:
      return "[a list of " + join(form.words, " \\| ") + "]";
    case ValueKind::formula:
      return "a formula" + in;
    case ValueKind::formulas:
      return "[a formula" + in + " per axis]";
    case ValueKind::number_rows:
      return "[[rows of numbers" + in + "]]";
    case ValueKind::formula_rows:
      return "[[rows of formulas" + in + "]]";
    case ValueKind::section:
      return "a section";
    case ValueKind::sections:
      return "a list of sections";
  }
  return "";
}

void add_section(const KeyNotes& notes, const std::string& path, std::string& page) {
  const auto keys = keys_in(notes, path);
  std::string rows;
  for (const KeyNote* key : keys) {
    if (is_section(*key, ValueKind::section) || is_section(*key, ValueKind::sections)) continue;
    const std::string name = last_part(key->path);
    rows += fmt::format("| `{}` | {} | {} | {} |\n", name == "*" ? "any" : name, value_in_words(*key),
                        notes.required(*key) ? "required" : default_in_words(*key, ""), key->meaning);
  }
  if (!rows.empty()) page += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n" + rows + "\n";
  for (const KeyNote* key : keys) {
    const bool list = is_section(*key, ValueKind::sections), one = is_section(*key, ValueKind::section);
    if (!list && !one) continue;
    std::string shown;
    for (std::size_t at = 0; at < key->path.size(); ++at)
      if (key->path.compare(at, 2, ".0") == 0)
        ++at;
      else
        shown += key->path[at];
    page +=
        fmt::format("## {}{}{}\n\n{}{}.\n\n", one ? "[" + shown + "]" : "", one && list ? " or " : "",
                    list ? "[[" + shown + "]]" : "", key->meaning, notes.required(*key) ? " (required)" : "");
    add_section(notes, list && !one ? key->path + ".0" : key->path, page);
  }
}

}  // namespace

std::vector<const KeyNote*> keys_in(const KeyNotes& notes, const std::string& section) {
  std::vector<const KeyNote*> keys;
  for (const KeyNote& key : notes.keys())
    if (!key.forms.empty() && section_of(key.path) == section) keys.push_back(&key);
  return keys;
}

std::string last_part(const std::string& path) {
  return path.substr(path.rfind('.') + 1);  // npos + 1 is 0
}

std::string unit_of(const KeyNote& key) {
  std::string unit;
  for (const ValueForm& form : key.forms) {
    const std::string one(form.quantity.unit);
    if (!unit.empty() && one != unit) return "";
    unit = one;
  }
  return unit;
}

std::string default_in_words(const KeyNote& key, const std::string& before) {
  if (key.otherwise.empty()) return "";
  return before + (before.empty() ? "" : "default ") +
         join({key.otherwise.begin(), key.otherwise.end()}, " or ") +
         (key.otherwise.size() > 1 ? ", by other keys" : "");
}

std::string value_in_words(const KeyNote& key) {
  std::vector<std::string> all;
  for (const ValueForm& form : key.forms) all.push_back(in_words(form));
  return join(all, ", or ");
}

std::string keys_page(const KeyNotes& notes, const std::string& title) {
  std::string page = fmt::format(
      "# {}\n\nMade by the program out of its readers (`plumb keys`). Numbers may carry a unit as a string, "
      "\"17 MPa\"; a bare number has the unit that stands here.\nA section that is left out is a thing not "
      "built. Which keys go together is said where one is refused.\n\n",
      title);
  add_section(notes, "", page);
  page.pop_back();
  return page;
}

}  // namespace plumb::app
