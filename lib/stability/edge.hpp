#pragma once
#include <functional>

namespace plumb {

/// Where a run turns from stable to unstable as one parameter grows.
struct Edge {
  double stable;    ///< the largest value found stable; NaN if the first one is unstable already
  double unstable;  ///< the least value found unstable; NaN if the last one is stable still
  int runs = 0;
};

/// Bisects between `from` and `to` (from < to) until unstable/stable - 1 or, where from is 0, their distance
/// over `to` is below `tolerance`; geometrically where from > 0. `to` is tried first, and `from` only when
/// the middle between them is unstable: a run with a small step costs the most. One edge is found, if there
/// are several: that some larger value is stable again is not seen.
Edge find_edge(double from, double to, double tolerance, const std::function<bool(double)>& is_stable);

}  // namespace plumb
