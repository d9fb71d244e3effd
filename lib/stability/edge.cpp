#include "lib/stability/edge.hpp"

#include <cmath>
#include <limits>

namespace plumb {

Edge find_edge(double from, double to, double tolerance, const std::function<bool(double)>& is_stable) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (is_stable(to)) return {to, none, 1};
  Edge edge{from, to, 1};
  bool known = false;  // that the lower end is stable
  const auto wide = [&] {
    return from > 0 ? edge.unstable / edge.stable - 1 > tolerance
                    : edge.unstable - edge.stable > tolerance * to;
  };
  const auto low_end_is_unstable = [&] {
    if (known) return false;
    known = true;
    ++edge.runs;
    return !is_stable(from);
  };
  while (wide()) {
    const double middle =
        from > 0 ? std::sqrt(edge.stable * edge.unstable) : 0.5 * (edge.stable + edge.unstable);
    const bool stable = is_stable(middle);
    ++edge.runs;
    (stable ? edge.stable : edge.unstable) = middle;
    known = known || stable;
    if (!stable && low_end_is_unstable()) return {none, from, edge.runs};
  }
  if (low_end_is_unstable()) return {none, from, edge.runs};
  return edge;
}

}  // namespace plumb
