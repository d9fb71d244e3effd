#include "lib/input/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/input/spelling.hpp"
#include "lib/input/unit_names.hpp"

namespace plumb {
namespace {

struct Unit {
  std::string_view symbol;
  double factor;
  Dimension dimension;
  bool prefixed;  ///< takes prefixes
};

constexpr double pi = std::numbers::pi;

constexpr std::array<Unit, 16> units{{
    {"m", 1.0, {0, 1, 0}, true},
    {"g", 1e-3, {1, 0, 0}, true},
    {"s", 1.0, {0, 0, 1}, true},
    {"Pa", 1.0, {1, -1, -2}, true},
    {"N", 1.0, {1, 1, -2}, true},
    {"J", 1.0, {1, 2, -2}, true},
    {"W", 1.0, {1, 2, -3}, true},
    {"rad", 1.0, {0, 0, 0}, false},
    {"deg", pi / 180.0, {0, 0, 0}, false},
    {"rev", 2.0 * pi, {0, 0, 0}, false},
    {"rpm", 2.0 * pi / 60.0, {0, 0, -1}, false},
    {"min", 60.0, {0, 0, 1}, false},
    {"h", 3600.0, {0, 0, 1}, false},
    {"t", 1e3, {1, 0, 0}, false},
    {"bar", 1e5, {1, -1, -2}, false},
    {"%", 1e-2, {0, 0, 0}, false},
}};

struct Prefix {
  std::string_view symbol;
  double factor;
};

constexpr std::array<Prefix, 9> prefixes{{{"n", 1e-9},
                                          {"u", 1e-6},
                                          {"\u00b5", 1e-6},  // micro sign
                                          {"\u03bc", 1e-6},  // Greek mu
                                          {"m", 1e-3},
                                          {"c", 1e-2},
                                          {"k", 1e3},
                                          {"M", 1e6},
                                          {"G", 1e9}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c + 0; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}

/// The nearest unit: one that differs in the size of letters only ("mpa"), or else by few letters.
std::string nearest_unit(std::string_view symbol) {
  // the common ones first: "mpa" is meant as MPa, not as mPa
  std::vector<std::string> known{"kg", "mm", "cm", "ms", "us", "kPa", "MPa", "GPa", "kN", "MN", "kJ", "kW"};
  for (const auto& unit : units) known.emplace_back(unit.symbol);
  for (const auto& unit : known)
    if (same_but_for_case(symbol, unit)) return unit;
  return nearest_name(symbol, known);
}

InputError unknown_unit(std::string_view symbol) {
  std::string prefixed, others;
  for (const auto& unit : units) (unit.prefixed ? prefixed : others) += " " + std::string(unit.symbol);
  const std::string near = nearest_unit(symbol);
  return {fmt::format("unknown unit \"{}\"", symbol),
          fmt::format("units:{} with prefixes n u m c k M G;{}", prefixed, others),
          near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)};
}

/// The unit of a symbol, whole first ("min" is not milli-inch), then prefix and rest.
std::optional<Unit> find_unit(std::string_view symbol) {
  for (const auto& unit : units)
    if (unit.symbol == symbol) return unit;
  for (const auto& prefix : prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    for (const auto& unit : units)
      if (unit.prefixed && unit.symbol == symbol.substr(prefix.symbol.size()))
        return Unit{symbol, unit.factor * prefix.factor, unit.dimension, false};
  }
  return std::nullopt;
}

/// "m^-3", "m-3" and "m3" as symbol and power.
std::pair<std::string_view, int> split_power(std::string_view factor) {
  const auto hat = factor.find('^');
  std::size_t end = factor.size();
  while (hat == std::string_view::npos && end > 0 && is_digit(factor[end - 1])) --end;
  if (end < factor.size() && end > 0 && factor[end - 1] == '-') --end;
  if (hat == std::string_view::npos && (end == factor.size() || end == 0)) return {factor, 1};
  const std::string_view digits = factor.substr(hat == std::string_view::npos ? end : hat + 1);
  int power = 0;
  const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), power);
  if (error != std::errc{} || last != digits.data() + digits.size() || std::abs(power) > 9)
    throw InputError(fmt::format("\"{}\" is not a power of a unit", factor),
                     "after ^ stands a whole number from -9 to 9", "write for example \"kg/m^3\"");
  return {factor.substr(0, hat == std::string_view::npos ? end : hat), power};
}

/// "m^-3": multiplies `result` by the unit to the power (times sign).
void multiply(Measured& result, std::string_view factor, int sign) {
  auto [symbol, power] = split_power(factor);
  const auto unit = find_unit(symbol);
  if (!unit) throw unknown_unit(symbol);
  power *= sign;
  result.value *= std::pow(unit->factor, power);
  result.dimension.mass += power * unit->dimension.mass;
  result.dimension.length += power * unit->dimension.length;
  result.dimension.time += power * unit->dimension.time;
}

/// The number in front; the rest of the text is left in `rest`.
std::optional<double> leading_number(std::string_view text, std::string_view& rest) {
  double value = 0.0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  rest = trimmed({end, static_cast<std::size_t>(text.data() + text.size() - end)});
  return value;
}

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == '*' || c == '/';
}

/// "1/3" and "1/3 m": quantities are not computed.
void refuse_fraction(std::string_view text, double number, std::string_view rest) {
  if (!rest.starts_with('/')) return;
  std::string_view unit;
  const auto denominator = leading_number(trimmed(rest.substr(1)), unit);
  if (!denominator || *denominator == 0) return;
  const std::string value = fmt::format("{:.4g}", number / *denominator);
  throw InputError(
      fmt::format("\"{}\" is a fraction", text), "a quantity is one number, which is not computed",
      unit.empty() ? fmt::format("write {}, with as many digits as you need", value)
                   : fmt::format("write \"{} {}\", with as many digits as you need", value, unit));
}

}  // namespace

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const auto& unit : units) names.emplace_back(unit.symbol);
  return names;
}

std::vector<std::string> prefix_names() {
  std::vector<std::string> names;
  for (const auto& prefix : prefixes) names.emplace_back(prefix.symbol);
  return names;
}

Measured parse_measured(std::string_view written) {
  const std::string text = in_plain_characters(written);
  if (const auto corrected = without_decimal_comma(text))
    throw InputError(fmt::format("\"{}\" has a decimal comma", written), "decimals follow a point",
                     fmt::format("write \"{}\"", *corrected));
  std::string_view rest;
  const auto number = leading_number(trimmed(text), rest);
  if (!number)
    throw InputError(fmt::format("\"{}\" is not a quantity", text), "it must begin with a number",
                     "write for example \"17 MPa\"");
  refuse_fraction(text, *number, rest);
  if (rest.starts_with("1/")) rest.remove_prefix(1);  // "5 1/s" is 5/s
  Measured result{1.0, {}};
  int sign = 1;
  bool operand_due = false;
  while (!rest.empty()) {
    if (rest.front() == '/' || rest.front() == '*') {
      if (operand_due)
        throw InputError(fmt::format("\"{}\" is not a quantity", text), "a unit is missing", "");
      sign = rest.front() == '/' ? -1 : 1;
      operand_due = true;
      rest = trimmed(rest.substr(1));
      continue;
    }
    std::size_t length = 0;
    while (length < rest.size() && !is_separator(rest[length])) ++length;
    multiply(result, rest.substr(0, length), sign);
    rest = trimmed(rest.substr(length));
    sign = 1;
    operand_due = false;
  }
  if (operand_due)
    throw InputError(fmt::format("\"{}\" is not a quantity", text), "it ends with an operator", "");
  result.value *= *number;
  return result;
}

bool looks_measured(std::string_view text) {
  std::string_view rest;
  if (!leading_number(trimmed(text), rest) || rest.empty()) return false;
  try {
    parse_measured(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

double parse_quantity(std::string_view text, const Quantity& expected) {
  const Measured measured = parse_measured(text);
  if (measured.dimension == expected.dimension) {
    std::string_view rest;
    leading_number(trimmed(text), rest);
    if (rest.empty() && !expected.unit.empty())
      throw InputError(
          fmt::format("\"{}\" has no unit", text), fmt::format("expected {}", expected.name),
          fmt::format("write \"{} {}\", or the bare number {}", trimmed(text), expected.unit, trimmed(text)));
    return measured.value;
  }
  const std::string wanted =
      expected.unit.empty() ? "" : fmt::format(" in {} or a multiple of it", expected.unit);
  throw InputError(fmt::format("\"{}\" has the wrong unit", text),
                   fmt::format("expected {}{}, found {}", expected.name, wanted, text_of(measured.dimension)),
                   expected.unit.empty()
                       ? "write a bare number"
                       : fmt::format("write a number with a unit such as \"{}\"", expected.unit));
}

std::string text_of(const Dimension& dimension) {
  std::string text;
  const auto add = [&](std::string_view symbol, int power) {
    if (power == 0) return;
    text += (text.empty() ? "" : " ") + std::string(symbol) + (power == 1 ? "" : fmt::format("^{}", power));
  };
  add("kg", dimension.mass);
  add("m", dimension.length);
  add("s", dimension.time);
  return text.empty() ? "no unit" : text;
}

}  // namespace plumb
