#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// Exponents of kg, m and s. Angles have none: rad is 1.
struct Dimension {
  int mass = 0, length = 0, time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// What a key of a scene file means: its name for messages, its dimension and the SI unit a bare number has.
struct Quantity {
  std::string_view name;
  Dimension dimension;
  std::string_view unit;  ///< empty: a pure number
};

namespace quantity {
inline constexpr Quantity number{"a pure number", {0, 0, 0}, ""};
inline constexpr Quantity length{"a length", {0, 1, 0}, "m"};
inline constexpr Quantity time{"a time", {0, 0, 1}, "s"};
inline constexpr Quantity stress{"a stress", {1, -1, -2}, "Pa"};
inline constexpr Quantity density{"a density", {1, -3, 0}, "kg/m^3"};
inline constexpr Quantity velocity{"a velocity", {0, 1, -1}, "m/s"};
inline constexpr Quantity acceleration{"an acceleration", {0, 1, -2}, "m/s^2"};
inline constexpr Quantity force_per_volume{"a force per volume", {1, -2, -2}, "N/m^3"};
inline constexpr Quantity rate{"a rate", {0, 0, -1}, "1/s"};
inline constexpr Quantity angular_velocity{"an angular velocity", {0, 0, -1}, "rad/s"};
}  // namespace quantity

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
