#include "lib/schemes/tlsph/compatible/solver/particles_by_cell.hpp"

#include <algorithm>
#include <compare>

#include "lib/schemes/tlsph/compatible/solver/lane_vector.hpp"

namespace plumb {
namespace {

/// Cells of a block along each axis. Their splines reach three beyond them, not to those of the next but one.
constexpr Index block_width = 4;

/// Where a particle is, from the outside inward.
struct Home {
  Index colour, block, cell;
  std::int32_t particle;
  auto operator<=>(const Home&) const = default;
};

template <int d>
Home home(const SplineGrid<d>& grid, const Vec<d>& X, Index i) {
  const auto cells = splines_at<d>(grid, X).cell;
  Home at{0, 0, 0, static_cast<std::int32_t>(i)};
  for (int k = d; k-- > 0;) {
    const Index block = cells[k] / block_width;
    at.colour = 2 * at.colour + block % 2;
    at.block = at.block * (grid.cells[k] / block_width + 1) + block;
    at.cell = at.cell * grid.cells[k] + cells[k];
  }
  return at;
}

}  // namespace

template <int d>
ParticlesByCell<d> particles_by_cell(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X) {
  std::vector<Home> all(X.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i) all[i] = home<d>(grid, X[i], i);
  std::sort(all.begin(), all.end());
  ParticlesByCell<d> by;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const bool colour = n == 0 || all[n].colour != all[n - 1].colour;
    const bool block = colour || all[n].block != all[n - 1].block;
    if (colour) by.colour_begin.push_back(static_cast<Index>(by.block_begin.size()));
    if (block) by.block_begin.push_back(static_cast<Index>(by.begin.size()));
    if (block || all[n].cell != all[n - 1].cell) by.begin.push_back(static_cast<Index>(n));
    by.particles.push_back(all[n].particle);
  }
  by.colour_begin.push_back(static_cast<Index>(by.block_begin.size()));
  by.block_begin.push_back(static_cast<Index>(by.begin.size()));
  by.begin.push_back(static_cast<Index>(all.size()));
  return by;
}

namespace {

/// Per line, from the place of the first spline to that of the line's first.
template <int d>
std::array<Index, lines<d>> to_lines(const SplineGrid<d>& grid) {
  std::array<Index, lines<d>> offset{};
  for (int line = 0; line < lines<d>; ++line)
    for (int k = 1, rest = line; k < d; ++k, rest /= 4) offset[line] += rest % 4 * grid.stride[k];
  return offset;
}

}  // namespace

template <int d>
void add_prolonged(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const Coefficients<d>& c,
                   Multipliers<d>& x) {
  using Lanes = LaneVector<double, lanes<d>>;
  const auto offset = to_lines(grid);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(X.size()); ++i) {
    const auto s = splines_at<d>(grid, X[i]);
    const auto product = across(s);
    const Coefficient<d>* first = c.data() + grid.place(s.cell);
    Lanes sum[d + 1];
    for (int k = 0; k <= d; ++k) sum[k] = load_lanes<Lanes>(x[i].data() + k * lanes<d>);
    for (int line = 0; line < lines<d>; ++line) {
      const double* at = first[offset[line]].data();
      Lanes value{}, slope{};
      for (int m = 0; m < 4; ++m) {
        const auto here = load_lanes<Lanes>(at + m * lanes<d>);
        value += s.value[0][m] * here;
        slope += s.slope[0][m] * here;
      }
      sum[0] += product[line][0] * value;
      sum[1] += product[line][0] * slope;
      for (int k = 1; k < d; ++k) sum[1 + k] += product[line][k] * value;
    }
    for (int k = 0; k <= d; ++k) store_lanes(sum[k], x[i].data() + k * lanes<d>);
  }
}

namespace {

/// What one particle adds: r_i is its part of the field.
template <int d>
void add_transposed(const SplineValues<d>& s, const std::array<Index, lines<d>>& offset,
                    const MultiplierBlock<d>& r, Coefficient<d>* first) {
  using Lanes = LaneVector<double, lanes<d>>;
  const auto product = across(s);
  Lanes own[d + 1];
  for (int k = 0; k <= d; ++k) own[k] = load_lanes<Lanes>(r.data() + k * lanes<d>);
  for (int line = 0; line < lines<d>; ++line) {
    Lanes value = product[line][0] * own[0];
    const Lanes slope = product[line][0] * own[1];
    for (int k = 1; k < d; ++k) value += product[line][k] * own[1 + k];
    double* at = first[offset[line]].data();
    for (int m = 0; m < 4; ++m, at += lanes<d>)
      store_lanes(load_lanes<Lanes>(at) + s.value[0][m] * value + s.slope[0][m] * slope, at);
  }
}

}  // namespace

template <int d>
void restrict_to(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const ParticlesByCell<d>& by_cell,
                 const Multipliers<d>& r, Coefficients<d>& c) {
  c.assign(grid.places, Coefficient<d>::Zero());
  const auto offset = to_lines(grid);
  for (std::size_t colour = 0; colour + 1 < by_cell.colour_begin.size(); ++colour)
#pragma omp parallel for schedule(static)
    for (Index block = by_cell.colour_begin[colour]; block < by_cell.colour_begin[colour + 1]; ++block) {
      const Index first = by_cell.block_begin[block], end = by_cell.block_begin[block + 1];
      for (Index n = by_cell.begin[first]; n < by_cell.begin[end]; ++n) {
        const Index i = by_cell.particles[n];
        const auto s = splines_at<d>(grid, X[i]);
        add_transposed<d>(s, offset, r[i], c.data() + grid.place(s.cell));
      }
    }
}

#define PLUMB_INSTANTIATE(d)                                                                                \
  template ParticlesByCell<d> particles_by_cell<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&);       \
  template void add_prolonged<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&, const Coefficients<d>&,  \
                                 Multipliers<d>&);                                                          \
  template void restrict_to<d>(const SplineGrid<d>&, const std::vector<Vec<d>>&, const ParticlesByCell<d>&, \
                               const Multipliers<d>&, Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
