#pragma once
#include <string_view>

namespace plumb {

/// Says what a field of a state is for.
enum class Role {
  evolves,  ///< integrated in time by the scheme's rates
  history,  ///< changed by the scheme between steps; kept and restarted
  cache     ///< found again from the rest; never written to a file
};

/// Describes one field of a state. A state is a plain struct that lists its fields once:
///   template <class Visit> void fields(Visit&& visit) { visit(FieldInfo{"velocity", "m/s"}, v); .. }
/// Restart, memory tables, checks for numbers that are not finite and Runge-Kutta stages use that list.
struct FieldInfo {
  std::string_view name;
  std::string_view unit;
  Role role = Role::evolves;
};

}  // namespace plumb
