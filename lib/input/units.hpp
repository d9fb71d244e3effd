#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/quantity.hpp"

namespace plumb {

/// A number with its unit taken off: `value` in SI units.
struct Measured {
  double value = 0.0;
  Dimension dimension;
};

/// Reads "17 MPa", "0.2 s", "5mm", "1.1 g/cm^3", "9.81 m s^-2", "90 deg", "30 %". Units: m g s rad N Pa J W
/// with the prefixes n u µ m c k M G; min, h, deg, rev, rpm, t, bar, %. Products by *, · or a space, one or
/// more /, powers as m^3, m3 or m³. A number with no unit is a pure number. Throws InputError (problem, why and
/// suggestion, without key or line).
Measured parse_measured(std::string_view text);

/// True if the text begins as a number with a unit does and no formula does: "5 m/s".
bool looks_measured(std::string_view text);

/// The SI value of `text` if it is such a quantity.
/// Throws InputError that says what was expected and found, and suggests the unit.
double parse_quantity(std::string_view text, const Quantity& expected);

/// "kg m^-1 s^-2" for messages; "no unit" for a pure number.
std::string text_of(const Dimension& dimension);

}  // namespace plumb
