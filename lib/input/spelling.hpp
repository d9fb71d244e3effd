#pragma once
#include <optional>
#include <string>
#include <string_view>

/// How people spell quantities, and what is meant.
namespace plumb {

/// True for 0 to 9, in any language of the machine.
inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Superscripts as powers and the middle dot as a product, in plain characters: "kg/m³" becomes "kg/m^3".
std::string in_plain_characters(std::string_view text);

/// What to write instead, if the text begins as a number with a decimal comma does ("0,5 s": "0.5 s"); "1, 2"
/// and "1,2,3" are lists.
std::optional<std::string> without_decimal_comma(std::string_view text);

/// True if text where a formula may stand is a number with a unit, or is meant as one ("0,5 m/s"). "2*t" is a
/// formula with the time, not two tonnes.
bool is_quantity(std::string_view text);

/// What to say of a line of a TOML file that has a decimal comma, as in "size = 0,5"; empty if it has none.
std::string hint_at_decimal_comma(const std::string& file, std::size_t line);

}  // namespace plumb
