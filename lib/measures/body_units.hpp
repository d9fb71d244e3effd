#pragma once

namespace plumb {

/// Units of sums over a body of d dimensions, and which components its angular momentum has. A body in 2D is a slice: its
/// sums are per thickness. A bar in 1D is a line: its sums are per cross-section.
template <int d>
struct BodyUnits {
  static constexpr const char* energy = d == 1 ? "J/m^2" : d == 2 ? "J/m" : "J";
  static constexpr const char* force = d == 1 ? "N/m^2" : d == 2 ? "N/m" : "N";
  static constexpr const char* linear_momentum = d == 1 ? "kg/(m s)" : d == 2 ? "kg/s" : "kg m/s";
  static constexpr const char* angular_momentum = d == 1 ? "kg/s" : d == 2 ? "kg m/s" : "kg m^2/s";
  /// Angular momentum has the components from here to z: none in 1D, z in 2D, all in 3D.
  static constexpr int first_angular = d == 1 ? 3 : d == 2 ? 2 : 0;
};

}  // namespace plumb
