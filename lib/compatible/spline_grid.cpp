#include "plumbline/compatible/spline_grid.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "plumbline/compatible/each_place.hpp"

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
    const double u = (X[k] - grid.origin[k]) / grid.spacing[k];
    s.cell[k] = std::clamp<Index>(static_cast<Index>(std::floor(u)), 0, grid.cells[k] - 1);
    const double x = u - static_cast<double>(s.cell[k]), y = 1 - x, per = 0.5 / grid.spacing[k];
    s.value[k] = {y * y * y / 6, (4 + x * x * (3 * x - 6)) / 6, (4 + y * y * (3 * y - 6)) / 6, x * x * x / 6};
    s.slope[k] = {-y * y * per, x * (3 * x - 4) * per, -y * (3 * y - 4) * per, x * x * per};
  }
  return s;
}

template <int d>
ParticlesByCell<d> particles_by_cell(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X) {
  struct At {
    Index colour, cell;
    std::int32_t particle;
  };
  std::vector<At> all(X.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i) {
    const auto s = splines_at<d>(grid, X[i]);
    Index colour = 0, cell = 0;
    for (int k = d; k-- > 0;) {
      colour = 4 * colour + s.cell[k] % 4;
      cell = cell * grid.cells[k] + s.cell[k];
    }
    all[i] = {colour, cell, static_cast<std::int32_t>(i)};
  }
  std::sort(all.begin(), all.end(), [](const At& a, const At& b) {
    return std::tie(a.colour, a.cell, a.particle) < std::tie(b.colour, b.cell, b.particle);
  });
  ParticlesByCell<d> by;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (n == 0 || all[n].colour != all[n - 1].colour)
      by.colour_begin.push_back(static_cast<Index>(by.begin.size()));
    if (n == 0 || all[n].cell != all[n - 1].cell) by.begin.push_back(static_cast<Index>(n));
    by.particles.push_back(all[n].particle);
  }
  by.colour_begin.push_back(static_cast<Index>(by.begin.size()));
  by.begin.push_back(static_cast<Index>(all.size()));
  return by;
}

namespace {

/// Product of the values along the axes but the first, and of slopes along one of them: entry 0 without a
/// slope, entry k with the slope along axis k.
template <int d>
std::array<double, d> across(const SplineValues<d>& s, int line) {
  std::array<double, d> product;
  product.fill(1);
  for (int k = 1; k < d; ++k, line /= 4)
    for (int p = 0; p < d; ++p) product[p] *= p == k ? s.slope[k][line % 4] : s.value[k][line % 4];
  return product;
}

template <int d>
Index line_offset(const SplineGrid<d>& grid, int line) {
  Index offset = 0;
  for (int k = 1; k < d; ++k, line /= 4) offset += line % 4 * grid.stride[k];
  return offset;
}

template <int d>
constexpr int lines = d == 1   ? 1
                      : d == 2 ? 4
                               : 16;

}  // namespace

template <int d>
void add_prolonged(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const Coefficients<d>& c,
                   Multipliers<d>& x) {
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i) {
    const auto s = splines_at<d>(grid, X[i]);
    const Coefficient<d>* first = c.data() + grid.place(s.cell);
    MultiplierBlock<d> sum = MultiplierBlock<d>::Zero();
    for (int line = 0; line < lines<d>; ++line) {
      const Coefficient<d>* at = first + line_offset(grid, line);
      Coefficient<d> value = Coefficient<d>::Zero(), slope = Coefficient<d>::Zero();
      for (int m = 0; m < 4; ++m) {
        value += s.value[0][m] * at[m];
        slope += s.slope[0][m] * at[m];
      }
      const auto product = across(s, line);
      sum.col(0) += product[0] * value;
      sum.col(1) += product[0] * slope;
      for (int k = 1; k < d; ++k) sum.col(1 + k) += product[k] * value;
    }
    x[i] += sum;
  }
}

template <int d>
void restrict_to(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const ParticlesByCell<d>& by_cell,
                 const Multipliers<d>& r, Coefficients<d>& c) {
  c.assign(grid.places, Coefficient<d>::Zero());
  for (std::size_t colour = 0; colour + 1 < by_cell.colour_begin.size(); ++colour)
#pragma omp parallel for schedule(static)
    for (Index cell = by_cell.colour_begin[colour]; cell < by_cell.colour_begin[colour + 1]; ++cell)
      for (Index n = by_cell.begin[cell]; n < by_cell.begin[cell + 1]; ++n) {
        const Index i = by_cell.particles[n];
        const auto s = splines_at<d>(grid, X[i]);
        Coefficient<d>* first = c.data() + grid.place(s.cell);
        for (int line = 0; line < lines<d>; ++line) {
          const auto product = across(s, line);
          Coefficient<d> value = product[0] * r[i].col(0);
          const Coefficient<d> slope = product[0] * r[i].col(1);
          for (int k = 1; k < d; ++k) value += product[k] * r[i].col(1 + k);
          Coefficient<d>* at = first + line_offset(grid, line);
          for (int m = 0; m < 4; ++m) at[m] += s.value[0][m] * value + s.slope[0][m] * slope;
        }
      }
}

namespace {

constexpr std::array<double, 5> two_scale = {0.125, 0.5, 0.75, 0.5, 0.125};

}  // namespace

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

#define PLUMB_INSTANTIATE(d)                                                                                \
  template SplineGrid<d> spline_grid<d>(const Vec<d>&, const Vec<d>&, const std::array<Index, d>&);         \
  template SplineGrid<d> grid_over<d>(const std::vector<Vec<d>>&, double);                                  \
  template SplineGrid<d> coarser<d>(const SplineGrid<d>&);                                                  \
  template SplineValues<d> splines_at<d>(const SplineGrid<d>&, const Vec<d>&);                              \
  template ParticlesByCell<d> particles_by_cell<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&);       \
  template void add_prolonged<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&, const Coefficients<d>&,  \
                                 Multipliers<d>&);                                                          \
  template void restrict_to<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&, const ParticlesByCell<d>&, \
                               const Multipliers<d>&, Coefficients<d>&);                                    \
  template void add_refined<d>(const SplineGrid<d>&, const Coefficients<d>&, const SplineGrid<d>&,          \
                               Coefficients<d>&);                                                           \
  template void coarsen<d>(const SplineGrid<d>&, const Coefficients<d>&, const SplineGrid<d>&,              \
                           Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
