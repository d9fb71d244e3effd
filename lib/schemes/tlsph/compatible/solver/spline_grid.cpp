#include "lib/schemes/tlsph/compatible/solver/spline_grid.hpp"

#include <algorithm>
#include <cmath>

#include "lib/schemes/tlsph/compatible/solver/each_place.hpp"

namespace plumb {

template <int d>
SplineGrid<d> spline_grid(const Vec<d>& origin, const Vec<d>& spacing, const std::array<Index, d>& cells) {
  SplineGrid<d> grid{origin, spacing, cells, {}, 1};
  for (int k = 0; k < d; ++k) {
    grid.stride[k] = grid.places;
    grid.places *= grid.splines(k) + 2 * spline_reach;
  }
  return grid;
}

template <int d>
SplineGrid<d> grid_over(const std::vector<Vec<d>>& X, double least) {
  Vec<d> low = X[0], high = X[0];
  for (const auto& x : X) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  Vec<d> spacing;
  std::array<Index, d> cells;
  for (int k = 0; k < d; ++k) {
    const double extent = high[k] - low[k];
    cells[k] = std::max<Index>(1, static_cast<Index>(extent / least));
    spacing[k] = std::max(least, extent / static_cast<double>(cells[k]));
  }
  return spline_grid<d>(low, spacing, cells);
}

template <int d>
SplineGrid<d> coarser(const SplineGrid<d>& grid) {
  std::array<Index, d> cells;
  for (int k = 0; k < d; ++k) cells[k] = (grid.cells[k] + 1) / 2;
  return spline_grid<d>(grid.origin, 2 * grid.spacing, cells);
}

template <int d>
SplineValues<d> splines_at(const SplineGrid<d>& grid, const Vec<d>& X) {
  SplineValues<d> s;
  for (int k = 0; k < d; ++k) {
    const double per_spacing = 1 / grid.spacing[k], u = (X[k] - grid.origin[k]) * per_spacing;
    s.cell[k] = std::clamp<Index>(static_cast<Index>(std::floor(u)), 0, grid.cells[k] - 1);
    const double x = u - static_cast<double>(s.cell[k]), y = 1 - x, per = 0.5 * per_spacing;
    s.value[k] = {y * y * y / 6, (4 + x * x * (3 * x - 6)) / 6, (4 + y * y * (3 * y - 6)) / 6, x * x * x / 6};
    s.slope[k] = {-y * y * per, x * (3 * x - 4) * per, -y * (3 * y - 4) * per, x * x * per};
  }
  return s;
}

template <int d>
std::array<std::array<double, d>, lines<d>> across(const SplineValues<d>& s) {
  std::array<std::array<double, d>, lines<d>> product;
  product[0].fill(1);
  int known = 1;
  for (int k = 1; k < d; ++k, known *= 4)
    for (int m = 4; m-- > 0;)  // lines with m = 0 last: they are in the place of what all are made from
      for (int line = 0; line < known; ++line)
        for (int p = 0; p < d; ++p)
          product[m * known + line][p] = product[line][p] * (p == k ? s.slope[k][m] : s.value[k][m]);
  return product;
}

template <int d>
void add_refined(const SplineGrid<d>& coarse, const Coefficients<d>& c, const SplineGrid<d>& fine,
                 Coefficients<d>& x) {
  each_spline(fine, [&](const std::array<Index, d>& k) {
    // coarse K with 2K - 3 <= k <= 2K + 1
    Coefficient<d> sum = Coefficient<d>::Zero();
    std::array<Index, d> first, count, K;
    Index all = 1;
    for (int a = 0; a < d; ++a) {
      first[a] = k[a] / 2;                       // ceil((k - 1) / 2)
      count[a] = (k[a] + 3) / 2 - first[a] + 1;  // to floor((k + 3) / 2)
      all *= count[a];
    }
    for (Index n = 0; n < all; ++n) {
      Index rest = n;
      double weight = 1;
      for (int a = 0; a < d; ++a, rest /= count[a - 1]) {
        K[a] = first[a] + rest % count[a];
        weight *= two_scale[k[a] - 2 * K[a] + 3];
      }
      sum += weight * c[coarse.place(K)];
    }
    x[fine.place(k)] += sum;
  });
}

template <int d>
void coarsen(const SplineGrid<d>& fine, const Coefficients<d>& r, const SplineGrid<d>& coarse,
             Coefficients<d>& c) {
  c.assign(coarse.places, Coefficient<d>::Zero());
  each_spline(coarse, [&](const std::array<Index, d>& K) {
    constexpr int all = d == 1 ? 5 : d == 2 ? 25 : 125;
    Coefficient<d> sum = Coefficient<d>::Zero();
    for (int n = 0; n < all; ++n) {
      int rest = n;
      double weight = 1;
      std::array<Index, d> k;
      bool inside = true;
      for (int a = 0; a < d; ++a, rest /= 5) {
        k[a] = 2 * K[a] - 3 + rest % 5;
        weight *= two_scale[rest % 5];
        inside = inside && k[a] >= 0 && k[a] < fine.splines(a);
      }
      if (inside) sum += weight * r[fine.place(k)];
    }
    c[coarse.place(K)] = sum;
  });
}

#define PLUMB_INSTANTIATE(d)                                                                        \
  template SplineGrid<d> spline_grid<d>(const Vec<d>&, const Vec<d>&, const std::array<Index, d>&); \
  template SplineGrid<d> grid_over<d>(const std::vector<Vec<d>>&, double);                          \
  template SplineGrid<d> coarser<d>(const SplineGrid<d>&);                                          \
  template std::array<std::array<double, d>, lines<d>> across<d>(const SplineValues<d>&);           \
  template SplineValues<d> splines_at<d>(const SplineGrid<d>&, const Vec<d>&);                      \
  template void add_refined<d>(const SplineGrid<d>&, const Coefficients<d>&, const SplineGrid<d>&,  \
                               Coefficients<d>&);                                                   \
  template void coarsen<d>(const SplineGrid<d>&, const Coefficients<d>&, const SplineGrid<d>&,      \
                           Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
