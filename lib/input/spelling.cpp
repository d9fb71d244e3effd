#include "lib/input/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "lib/input/units.hpp"

namespace plumb {
namespace {}  // namespace

std::string in_plain_characters(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 11> raised{{{"\u207b", '-'},
                                                                      {"\u2070", '0'},
                                                                      {"\u00b9", '1'},
                                                                      {"\u00b2", '2'},
                                                                      {"\u00b3", '3'},
                                                                      {"\u2074", '4'},
                                                                      {"\u2075", '5'},
                                                                      {"\u2076", '6'},
                                                                      {"\u2077", '7'},
                                                                      {"\u2078", '8'},
                                                                      {"\u2079", '9'}}};
  constexpr std::string_view dot = "\u00b7";
  std::string plain;
  bool in_power = false;
  while (!text.empty()) {
    const auto found = std::find_if(raised.begin(), raised.end(),
                                    [&](const auto& entry) { return text.starts_with(entry.first); });
    if (found != raised.end()) {
      plain += in_power ? "" : "^";
      plain += found->second;
      text.remove_prefix(found->first.size());
    } else if (text.starts_with(dot)) {
      plain += '*';
      text.remove_prefix(dot.size());
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
    in_power = found != raised.end();
  }
  return plain;
}

std::optional<std::string> without_decimal_comma(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  std::size_t digits = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  while (digits < text.size() && is_digit(text[digits])) ++digits;
  if (digits == 0 || !is_digit(text[digits - 1]) || digits + 1 >= text.size() || text[digits] != ',' ||
      !is_digit(text[digits + 1]) || text.find(',', digits + 1) != std::string_view::npos)
    return std::nullopt;
  std::string corrected(text);
  corrected[digits] = '.';
  return corrected;
}

bool is_quantity(std::string_view text) {
  const auto star = text.find('*');
  if (star != std::string_view::npos && text.substr(star + 1).starts_with('t')) return false;
  const auto corrected = without_decimal_comma(text);
  return looks_measured(corrected ? std::string_view(*corrected) : text);
}

std::string hint_at_decimal_comma(const std::string& file, std::size_t line) {
  std::istringstream lines(file);
  std::string content;
  for (std::size_t n = 0; n < line && std::getline(lines, content);) ++n;
  const auto equals = content.find('=');
  if (equals == std::string::npos) return "";
  const auto corrected = without_decimal_comma(content.substr(equals + 1));
  return corrected ? fmt::format("decimals follow a point: write {}", *corrected) : "";
}

}  // namespace plumb
