#include "lib/input/section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/input/spelling.hpp"

namespace plumb {

Section::Section(const TomlValue& table, std::string path) : table_(&table), path_(std::move(path)) {}

std::string Section::dotted(const std::string& key) const {
  return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
}

const TomlValue* Section::find(const std::string& key) const {
  known_.insert(key);
  return table_->find(key);
}

bool Section::has(const std::string& key) const {
  return find(key) != nullptr;
}

bool Section::is_array(const std::string& key) const {
  const TomlValue* value = find(key);
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

double Section::number(const std::string& key, const Quantity& expected, Sign sign) const {
  return as_number(required(key), key, expected, sign);
}

double Section::any_number(const std::string& key) const {
  const TomlValue& value = required(key);
  if (!value.is(TomlValue::Kind::text)) return number(key, quantity::number);
  try {
    const Measured measured = parse_measured(value.text);
    return number(key, {"a number", measured.dimension, ""});
  } catch (const SceneError&) {
    throw;
  } catch (const InputError& error) {
    fail(key, error.problem(), error.why(), error.suggestion());
  }
}

std::optional<double> Section::optional_number(const std::string& key, const Quantity& expected,
                                               Sign sign) const {
  const TomlValue* value = find(key);
  return value ? std::optional(as_number(*value, key, expected, sign)) : std::nullopt;
}

double Section::number_or(const std::string& key, double otherwise, const Quantity& expected,
                          Sign sign) const {
  return optional_number(key, expected, sign).value_or(otherwise);
}

long Section::as_integer(const TomlValue& value, const std::string& key, long least) const {
  if (!value.is(TomlValue::Kind::integer)) wrong_type(value, key, "a whole number");
  if (value.whole < least)
    throw SceneError(value.where, dotted(key), fmt::format("{} is too small", value.whole),
                     fmt::format("at least {}", least), "");
  return value.whole;
}

std::optional<long> Section::optional_integer(const std::string& key, long least) const {
  const TomlValue* value = find(key);
  return value ? std::optional(as_integer(*value, key, least)) : std::nullopt;
}

long Section::integer_or(const std::string& key, long otherwise, long least) const {
  return optional_integer(key, least).value_or(otherwise);
}

bool Section::flag_or(const std::string& key, bool otherwise) const {
  const TomlValue* value = find(key);
  if (!value) return otherwise;
  if (!value->is(TomlValue::Kind::boolean)) wrong_type(*value, key, "true or false");
  return value->flag;
}

std::string Section::text(const std::string& key) const {
  const TomlValue& value = required(key);
  if (!value.is(TomlValue::Kind::text)) wrong_type(value, key, "a string in quotes");
  if (value.text.empty()) fail(key, "empty string", "it needs at least one character");
  return value.text;
}

std::string Section::text_or(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::string Section::choice_or(const std::string& key, const std::string& otherwise,
                               const std::vector<std::string>& valid) const {
  std::string name = text_or(key, otherwise);
  for (const auto& one : valid)
    if (one == name) return name;
  const InputError error = unknown_name(key, name, valid);
  fail(key, error.problem(), error.why(), error.suggestion());
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

std::vector<double> Section::numbers(const std::string& key, std::size_t count, const Quantity& expected,
                                     Sign sign) const {
  std::vector<double> all;
  for (const auto& item : array(key, count, "numbers").items)
    all.push_back(as_number(item, key, expected, sign));
  return all;
}

std::vector<double> Section::points(const std::string& key, std::size_t dimension,
                                    const Quantity& expected) const {
  const auto& items = array(key, 0, "points").items;
  if (!items.front().is(TomlValue::Kind::array)) return numbers(key, 0, expected);
  std::vector<double> all;
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (!items[n].is(TomlValue::Kind::array)) wrong_type(items[n], key, "points, as the first entry is one");
    if (items[n].items.size() != dimension)
      fail(key, fmt::format("point {} has {} values", n, items[n].items.size()),
           fmt::format("expected {}, as many as the dimension", dimension));
    for (const auto& item : items[n].items) all.push_back(as_number(item, key, expected, Sign::any));
  }
  return all;
}

std::vector<long> Section::integers(const std::string& key, std::size_t count, long least) const {
  std::vector<long> all;
  for (const auto& item : array(key, count, "whole numbers").items)
    all.push_back(as_integer(item, key, least));
  return all;
}

std::vector<std::string> Section::texts(const std::string& key) const {
  std::vector<std::string> all;
  for (const auto& item : array(key, 0, "strings or numbers").items) {
    if (item.is(TomlValue::Kind::text))
      all.push_back(item.text);
    else if (item.is(TomlValue::Kind::integer) || item.is(TomlValue::Kind::real))
      all.push_back(fmt::format("{}", item.number));
    else
      wrong_type(item, key, "strings or numbers");
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

Expression Section::formula(const std::string& key, int dimension, const Quantity& expected,
                            Variables variables) const {
  return as_formula(required(key), key, dimension, expected, variables);
}

std::vector<Expression> Section::formulas(const std::string& key, int dimension, const Quantity& expected,
                                          Variables variables) const {
  std::vector<Expression> all;
  for (const auto& item : array(key, static_cast<std::size_t>(dimension), "formulas").items)
    all.push_back(as_formula(item, key, dimension, expected, variables));
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

std::vector<std::vector<double>> Section::number_rows(const std::string& key,
                                                      const Quantity& expected) const {
  return square_of(key, [&](const TomlValue& item) { return as_number(item, key, expected, Sign::any); });
}

std::vector<std::vector<Expression>> Section::formula_rows(const std::string& key,
                                                           const Quantity& expected) const {
  return square_of(key, [&](const TomlValue& item) {
    return as_formula(item, key, 0, expected, Variables::space_and_time);
  });
}

Section Section::section(const std::string& key) const {
  const TomlValue& value = required(key);
  if (!value.is(TomlValue::Kind::table))
    wrong_type(value, key, fmt::format("a section [{}]", dotted(key)),
               value.is(TomlValue::Kind::array) ? fmt::format("there is one [{}] only", dotted(key)) : "");
  return {value, dotted(key)};
}

std::optional<Section> Section::optional_section(const std::string& key) const {
  return has(key) ? std::optional(section(key)) : std::nullopt;
}

std::vector<Section> Section::sections(const std::string& key) const {
  std::vector<Section> all;
  const TomlValue* value = find(key);
  if (!value) return all;
  if (!value->is(TomlValue::Kind::array))
    wrong_type(*value, key, "a list of sections", fmt::format("write [[{}]]", dotted(key)));
  for (const auto& item : value->items) {
    const std::string path = fmt::format("{}.{}", dotted(key), all.size());
    if (!item.is(TomlValue::Kind::table)) wrong_type(item, key, fmt::format("sections [[{}]]", dotted(key)));
    all.emplace_back(item, path);
  }
  return all;
}

void Section::reject_unknown() const {
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
  return table_->names;
}

}  // namespace plumb
