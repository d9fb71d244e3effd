#pragma once
#include <string_view>

namespace plumb {

/// Exponents of kg, m and s. Angles have none: rad is 1.
struct Dimension {
  int mass = 0, length = 0, time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// What a number of an input file means: its name for messages, its dimension and the SI unit that a bare
/// number has.
struct Quantity {
  std::string_view name;
  Dimension dimension;
  std::string_view unit;  ///< empty: a pure number
};

namespace quantity {
/// Names what the numbers of input files are.
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

/// What a number must satisfy, with the words for it.
enum class Sign { any, positive, not_negative };

}  // namespace plumb
