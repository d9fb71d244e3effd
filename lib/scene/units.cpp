#include "plumbline/scene/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "plumbline/core/error.hpp"

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

InputError unknown_unit(std::string_view symbol) {
  std::vector<std::string> known{"kg", "mm", "cm", "ms", "us", "kPa", "MPa", "GPa", "kN", "kJ"};
  for (const auto& unit : units) known.emplace_back(unit.symbol);
  const std::string near = nearest_name(symbol, known);
  return {fmt::format("unknown unit \"{}\"", symbol),
          "units: m g s Pa N J W with prefixes n u m c k M G; rad deg "
          "rev rpm min h t bar %",
          near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)};
}

/// The unit of a symbol, whole first ("min" is not milli-inch), then prefix and rest.
Unit find_unit(std::string_view symbol) {
  if (symbol == "1") return {symbol, 1, {}, false};  // "5 1/s"
  for (const auto& unit : units)
    if (unit.symbol == symbol) return unit;
  for (const auto& prefix : prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    for (const auto& unit : units)
      if (unit.prefixed && unit.symbol == symbol.substr(prefix.symbol.size()))
        return {symbol, unit.factor * prefix.factor, unit.dimension, false};
  }
  throw unknown_unit(symbol);
}

/// "m^-3": multiplies `result` by the unit to the power (times sign).
void multiply(Measured& result, std::string_view factor, int sign) {
  const auto hat = factor.find('^');
  int power = 1;
  if (hat != std::string_view::npos) {
    const std::string_view digits = factor.substr(hat + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), power);
    if (error != std::errc{} || end != digits.data() + digits.size() || std::abs(power) > 9)
      throw InputError(fmt::format("\"{}\" is not a power of a unit", factor),
                       "after ^ stands a whole number from -9 to 9", "");
  }
  const Unit unit = find_unit(factor.substr(0, hat));
  power *= sign;
  result.value *= std::pow(unit.factor, power);
  result.dimension.mass += power * unit.dimension.mass;
  result.dimension.length += power * unit.dimension.length;
  result.dimension.time += power * unit.dimension.time;
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

}  // namespace

Measured parse_measured(std::string_view text) {
  std::string_view rest;
  const auto number = leading_number(trimmed(text), rest);
  if (!number)
    throw InputError(fmt::format("\"{}\" is not a quantity", text), "it must begin with a number",
                     "write for example \"17 MPa\"");
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
