#include "lib/input/section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/input/spelling.hpp"

namespace plumb {

namespace {

/// A default as TOML.
std::string toml_of(double value) {
  return fmt::format("{}", value);
}
std::string toml_of(bool value) {
  return value ? "true" : "false";
}
std::string toml_of(const std::string& text) {
  return text.empty() ? "" : "\"" + text + "\"";
}

}  // namespace

Section::Section(const TomlValue& table, std::string path, KeyNotes* notes)
    : table_(&table), path_(std::move(path)), notes_(notes) {}

void Section::note(const Key& key, const std::vector<ValueForm>& forms, bool optional,
                   const std::string& otherwise) const {
  if (notes_) notes_->take(path_, key, forms, optional, otherwise);
}

void Section::mark_known(const std::vector<std::string>& keys) const {
  known_.insert(keys.begin(), keys.end());
}

std::string Section::dotted(const std::string& key) const {
  return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
}

const TomlValue* Section::find(const std::string& key) const {
  known_.insert(key);
  return table_->find(key);
}

bool Section::has(const Key& key) const {
  note(key, {}, true);
  return find(key.name) != nullptr;
}

bool Section::is_array(const Key& key) const {
  note(key, {}, false);
  const TomlValue* value = find(key.name);
  return value && value->is(TomlValue::Kind::array);
}

Location Section::where(const std::string& key) const {
  const TomlValue* value = table_->find(key);
  return value ? value->where : table_->where;
}

void Section::fail(const std::string& key, const std::string& problem, const std::string& why,
                   const std::string& suggestion) const {
  throw SceneError(where(key), dotted(key), problem, why, suggestion);
}

void Section::wrong_type(const TomlValue& value, const std::string& key, const std::string& expected,
                         const std::string& suggestion) const {
  throw SceneError(value.where, dotted(key), "wrong type",
                   fmt::format("expected {}, found {}", expected, description_of(value)), suggestion);
}

const TomlValue& Section::required(const std::string& key) const {
  if (const TomlValue* value = find(key)) return *value;
  std::vector<std::string> strangers;
  for (const auto& name : table_->names)
    if (!known_.contains(name)) strangers.push_back(name);
  const std::string near = nearest_name(key, strangers);
  fail(key, path_.empty() ? "missing section" : "missing key", "it has no default",
       near.empty() ? path_.empty() ? fmt::format("add [{}]", key) : fmt::format("add it to [{}]", path_)
                    : fmt::format("did you mean it by \"{}\" in line {}?", near, where(near).line));
}

double Section::as_number(const TomlValue& value, const std::string& key, const Quantity& expected,
                          Sign sign) const {
  double number = value.number;
  if (value.is(TomlValue::Kind::text)) {
    try {
      number = parse_quantity(value.text, expected);
    } catch (const InputError& error) {
      throw SceneError(value.where, dotted(key), error.problem(), error.why(), error.suggestion());
    }
  } else if (!value.is(TomlValue::Kind::integer) && !value.is(TomlValue::Kind::real)) {
    const std::string unit(expected.unit);
    wrong_type(value, key,
               unit.empty() ? std::string("a number") : fmt::format("{} in {}", expected.name, unit));
  }
  const auto refuse = [&](const std::string& problem, const std::string& why) {
    throw SceneError(value.where, dotted(key), problem, why, "");
  };
  if (!std::isfinite(number)) refuse(fmt::format("{} is not finite", number), "every number must be");
  if (sign == Sign::positive && !(number > 0.0))
    refuse(fmt::format("{} is not positive", number), "it must be");
  if (sign == Sign::not_negative && number < 0.0)
    refuse(fmt::format("{} is negative", number), "it must not be");
  return number;
}

double Section::read_number(const std::string& key, const Quantity& expected, Sign sign) const {
  return as_number(required(key), key, expected, sign);
}

double Section::number(const Key& key, const Quantity& expected, Sign sign) const {
  note(key, {{ValueKind::number, expected, sign}}, false);
  return read_number(key.name, expected, sign);
}

double Section::any_number(const Key& key) const {
  note(key, {{ValueKind::any_number}}, false);
  const TomlValue& value = required(key.name);
  if (!value.is(TomlValue::Kind::text)) return read_number(key.name, quantity::number, Sign::any);
  try {
    const Measured measured = parse_measured(value.text);
    return read_number(key.name, {"a number", measured.dimension, ""}, Sign::any);
  } catch (const SceneError&) {
    throw;
  } catch (const InputError& error) {
    fail(key.name, error.problem(), error.why(), error.suggestion());
  }
}

std::optional<double> Section::optional_number(const Key& key, const Quantity& expected, Sign sign) const {
  note(key, {{ValueKind::number, expected, sign}}, true);
  const TomlValue* value = find(key.name);
  return value ? std::optional(as_number(*value, key.name, expected, sign)) : std::nullopt;
}

double Section::number_or(const Key& key, double otherwise, const Quantity& expected, Sign sign) const {
  note(key, {}, true, toml_of(otherwise));
  return optional_number(key, expected, sign).value_or(otherwise);
}

long Section::as_integer(const TomlValue& value, const std::string& key, long least) const {
  if (!value.is(TomlValue::Kind::integer)) wrong_type(value, key, "a whole number");
  if (value.whole < least)
    throw SceneError(value.where, dotted(key), fmt::format("{} is too small", value.whole),
                     fmt::format("at least {}", least), "");
  return value.whole;
}

long Section::integer(const Key& key, long least) const {
  note(key, {{.kind = ValueKind::integer, .least = least}}, false);
  return as_integer(required(key.name), key.name, least);
}

std::optional<long> Section::optional_integer(const Key& key, long least) const {
  note(key, {{.kind = ValueKind::integer, .least = least}}, true);
  const TomlValue* value = find(key.name);
  return value ? std::optional(as_integer(*value, key.name, least)) : std::nullopt;
}

long Section::integer_or(const Key& key, long otherwise, long least) const {
  note(key, {}, true, std::to_string(otherwise));
  return optional_integer(key, least).value_or(otherwise);
}

bool Section::flag_or(const Key& key, bool otherwise) const {
  note(key, {{ValueKind::flag}}, true, toml_of(otherwise));
  const TomlValue* value = find(key.name);
  if (!value) return otherwise;
  if (!value->is(TomlValue::Kind::boolean)) wrong_type(*value, key.name, "true or false");
  return value->flag;
}

std::string Section::read_text(const std::string& key) const {
  const TomlValue& value = required(key);
  if (!value.is(TomlValue::Kind::text)) wrong_type(value, key, "a string in quotes");
  if (value.text.empty()) fail(key, "empty string", "it needs at least one character");
  return value.text;
}

std::string Section::text(const Key& key) const {
  note(key, {{ValueKind::text}}, false);
  return read_text(key.name);
}

std::string Section::text_or(const Key& key, const std::string& otherwise) const {
  note(key, {{ValueKind::text}}, true, toml_of(otherwise));
  return find(key.name) ? read_text(key.name) : otherwise;
}

std::string Section::read_choice(const std::string& key, const std::string& name,
                                 const std::vector<std::string>& valid) const {
  for (const auto& one : valid)
    if (one == name) return name;
  const InputError error = unknown_name(key, name, valid);
  fail(key, error.problem(), error.why(), error.suggestion());
}

std::string Section::choice(const Key& key, const std::vector<std::string>& valid) const {
  if (valid.empty()) return text(key);
  note(key, {{.kind = ValueKind::choice, .words = valid}}, false);
  return read_choice(key.name, read_text(key.name), valid);
}

std::string Section::choice_or(const Key& key, const std::string& otherwise,
                               const std::vector<std::string>& valid) const {
  note(key, {{.kind = ValueKind::choice, .words = valid}}, true, toml_of(otherwise));
  return read_choice(key.name, find(key.name) ? read_text(key.name) : otherwise, valid);
}

const TomlValue& Section::array(const std::string& key, std::size_t count, const std::string& of_what) const {
  const TomlValue& value = required(key);
  const std::string size = count == 0 ? "" : fmt::format("{} ", count);
  if (!value.is(TomlValue::Kind::array))
    wrong_type(value, key, fmt::format("an array of {}{}", size, of_what));
  if (count != 0 && value.items.size() != count)
    fail(key, fmt::format("{} values", value.items.size()),
         fmt::format("expected {}, as many as the dimension", count));
  if (value.items.empty()) fail(key, "empty array", "it needs at least one value");
  return value;
}

std::vector<double> Section::read_numbers(const std::string& key, std::size_t count, const Quantity& expected,
                                          Sign sign) const {
  std::vector<double> all;
  for (const auto& item : array(key, count, "numbers").items)
    all.push_back(as_number(item, key, expected, sign));
  return all;
}

std::vector<double> Section::numbers(const Key& key, std::size_t count, const Quantity& expected,
                                     Sign sign) const {
  note(key, {{.kind = ValueKind::numbers, .quantity = expected, .sign = sign, .count = count}}, false);
  return read_numbers(key.name, count, expected, sign);
}

std::vector<double> Section::points(const Key& key, std::size_t dimension, const Quantity& expected) const {
  note(key, {{.kind = ValueKind::points, .quantity = expected, .count = dimension}}, false);
  const auto& items = array(key.name, 0, "points").items;
  if (!items.front().is(TomlValue::Kind::array)) return read_numbers(key.name, 0, expected, Sign::any);
  std::vector<double> all;
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (!items[n].is(TomlValue::Kind::array))
      wrong_type(items[n], key.name, "points, as the first entry is one");
    if (items[n].items.size() != dimension)
      fail(key.name, fmt::format("point {} has {} values", n, items[n].items.size()),
           fmt::format("expected {}, as many as the dimension", dimension));
    for (const auto& item : items[n].items) all.push_back(as_number(item, key.name, expected, Sign::any));
  }
  return all;
}

std::vector<long> Section::integers(const Key& key, std::size_t count, long least) const {
  note(key, {{.kind = ValueKind::integers, .least = least, .count = count}}, false);
  std::vector<long> all;
  for (const auto& item : array(key.name, count, "whole numbers").items)
    all.push_back(as_integer(item, key.name, least));
  return all;
}

std::vector<std::string> Section::texts(const Key& key) const {
  return texts(key, {});
}

std::vector<std::string> Section::texts(const Key& key, const std::vector<std::string>& words) const {
  note(key, {{.kind = words.empty() ? ValueKind::texts : ValueKind::choices, .words = words}}, false);
  std::vector<std::string> all;
  for (const auto& item : array(key.name, 0, "strings or numbers").items) {
    if (item.is(TomlValue::Kind::text))
      all.push_back(item.text);
    else if (item.is(TomlValue::Kind::integer) || item.is(TomlValue::Kind::real))
      all.push_back(fmt::format("{}", item.number));
    else
      wrong_type(item, key.name, "strings or numbers");
  }
  return all;
}

Expression Section::as_formula(const TomlValue& value, const std::string& key, int dimension,
                               const Quantity& expected, Variables variables) const {
  if (!value.is(TomlValue::Kind::text) || is_quantity(value.text))
    return Expression::constant(as_number(value, key, expected, Sign::any));
  try {
    return Expression(value.text, dimension, text_of(value.where) + ": " + dotted(key), variables);
  } catch (const InputError&) {  // once more without the place, which SceneError adds
    try {
      Expression(value.text, dimension, "", variables);
    } catch (const InputError& error) {
      throw SceneError(value.where, dotted(key), error.problem(), error.why(), error.suggestion());
    }
    throw;
  }
}

Expression Section::formula(const Key& key, int dimension, const Quantity& expected,
                            Variables variables) const {
  note(key, {{ValueKind::formula, expected}}, false);
  return as_formula(required(key.name), key.name, dimension, expected, variables);
}

std::vector<Expression> Section::formulas(const Key& key, int dimension, const Quantity& expected,
                                          Variables variables) const {
  const auto count = static_cast<std::size_t>(dimension);
  note(key, {{.kind = ValueKind::formulas, .quantity = expected, .count = count}}, false);
  std::vector<Expression> all;
  for (const auto& item : array(key.name, count, "formulas").items)
    all.push_back(as_formula(item, key.name, dimension, expected, variables));
  return all;
}

template <class Read>
auto Section::square_of(const std::string& key, Read&& read) const {
  std::vector<std::vector<decltype(read(TomlValue()))>> rows;
  const TomlValue& all = array(key, 0, "rows");
  for (const auto& row : all.items) {
    if (!row.is(TomlValue::Kind::array)) wrong_type(row, key, "an array of rows", "write [[a, b], [c, d]]");
    if (row.items.size() != all.items.size() || row.items.size() > 3)
      fail(key, fmt::format("a row of {} in an array of {} rows", row.items.size(), all.items.size()),
           "it must be square, of at most three rows");
    rows.emplace_back();
    for (const auto& item : row.items) rows.back().push_back(read(item));
  }
  return rows;
}

std::vector<std::vector<double>> Section::number_rows(const Key& key, const Quantity& expected) const {
  note(key, {{ValueKind::number_rows, expected}}, false);
  return square_of(key.name,
                   [&](const TomlValue& item) { return as_number(item, key.name, expected, Sign::any); });
}

std::vector<std::vector<Expression>> Section::formula_rows(const Key& key, const Quantity& expected) const {
  note(key, {{ValueKind::formula_rows, expected}}, false);
  return square_of(key.name, [&](const TomlValue& item) {
    return as_formula(item, key.name, 0, expected, Variables::space_and_time);
  });
}

Section Section::read_section(const std::string& key) const {
  const TomlValue& value = required(key);
  if (!value.is(TomlValue::Kind::table))
    wrong_type(value, key, fmt::format("a section [{}]", dotted(key)),
               value.is(TomlValue::Kind::array) ? fmt::format("there is one [{}] only", dotted(key)) : "");
  return {value, dotted(key), notes_};
}

Section Section::section(const Key& key) const {
  note(key, {{ValueKind::section}}, false);
  return read_section(key.name);
}

std::optional<Section> Section::optional_section(const Key& key) const {
  note(key, {{ValueKind::section}}, true);
  return find(key.name) ? std::optional(read_section(key.name)) : std::nullopt;
}

std::vector<Section> Section::sections(const Key& key) const {
  const TomlValue* value = find(key.name);
  note(key, {{ValueKind::sections}}, !value);  // whoever asks where there is none can do without
  std::vector<Section> all;
  if (!value) return all;
  if (!value->is(TomlValue::Kind::array))
    wrong_type(*value, key.name, "a list of sections", fmt::format("write [[{}]]", dotted(key.name)));
  for (const auto& item : value->items) {
    const std::string path = fmt::format("{}.{}", dotted(key.name), all.size());
    if (!item.is(TomlValue::Kind::table))
      wrong_type(item, key.name, fmt::format("sections [[{}]]", dotted(key.name)));
    all.emplace_back(item, path, notes_);
  }
  return all;
}

void Section::reject_unknown() const {
  if (notes_) notes_->close(path_, known_);
  for (const auto& name : table_->names) {
    if (known_.contains(name)) continue;
    const std::vector<std::string> valid(known_.begin(), known_.end());
    const std::string near = nearest_name(name, valid);
    fail(name, path_.empty() ? "unknown section" : "unknown key", "valid: " + join(valid),
         near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
  }
}

const std::vector<std::string>& Section::all_keys() const {
  known_.insert(table_->names.begin(), table_->names.end());
  note({"*"}, {}, true);
  return table_->names;
}

}  // namespace plumb
