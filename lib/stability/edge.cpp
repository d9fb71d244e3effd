#include "plumbline/stability/edge.hpp"

#include <cmath>
#include <limits>

namespace plumb {

Edge find_edge(double from, double to, double tolerance, const std::function<bool(double)>& is_stable) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!is_stable(from)) return {none, from, 1};
  if (is_stable(to)) return {to, none, 2};
  Edge edge{from, to, 2};
  const auto wide = [&] {
    return from > 0 ? edge.unstable / edge.stable - 1 > tolerance
                    : edge.unstable - edge.stable > tolerance * to;
  };
  while (wide()) {
    const double middle =
        from > 0 ? std::sqrt(edge.stable * edge.unstable) : 0.5 * (edge.stable + edge.unstable);
    (is_stable(middle) ? edge.stable : edge.unstable) = middle;
    ++edge.runs;
  }
  return edge;
}

}  // namespace plumb
