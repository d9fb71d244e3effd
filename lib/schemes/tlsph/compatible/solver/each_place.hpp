#pragma once
#include "lib/schemes/tlsph/compatible/solver/spline_grid.hpp"

namespace plumb {

/// Calls action(k) for every spline of the grid, lines of the first axis one after the other on each thread.
template <int d, class Action>
void each_spline(const SplineGrid<d>& grid, Action&& action) {
  Index all = 1;
  for (int a = 1; a < d; ++a) all *= grid.splines(a);
#pragma omp parallel for schedule(static)
  for (Index n = 0; n < all; ++n) {
    std::array<Index, d> k;
    Index rest = n;
    for (int a = 1; a < d; ++a) {
      k[a] = rest % grid.splines(a);
      rest /= grid.splines(a);
    }
    for (k[0] = 0; k[0] < grid.splines(0); ++k[0]) action(k);
  }
}

}  // namespace plumb
