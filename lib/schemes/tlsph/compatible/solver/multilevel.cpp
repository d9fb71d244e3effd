#include "lib/schemes/tlsph/compatible/solver/multilevel.hpp"

#include <algorithm>
#include <cmath>

#include "lib/schemes/tlsph/compatible/solver/chebyshev.hpp"

namespace plumb {
namespace {

/// Smoothing steps on the bonds, the finest grid and the coarser ones: the fastest of the few combinations
/// that were tried at 1e4 particles.
constexpr int bond_sweeps = 8, spline_sweeps = 2, coarse_sweeps = 6;
/// The coarsest level is solved densely, with `few_rows` within a second, with `most_rows` within a quarter
/// of a minute. It alone sees the changes of volumes, and where it is too wide for that iterations double:
/// large clouds, which can afford it, get more rows (measured, THEORY chapter 11).
constexpr Index few_rows = 700, most_rows = 1500, particles_per_row = 500;

/// x += approximately matrix^-1 r; r becomes what is left of it.
template <int d>
void smooth(const SplineSmoother<d>& matrix, int sweeps, RoughCoefficients<d>& r, Coefficients<d>& x) {
  RoughCoefficients<d> z(r.size(), RoughCoefficient<d>::Zero()), Az(r.size());
  for (int n = 1; n <= sweeps; ++n) {
    const auto step = chebyshev(n, matrix.largest);
    const auto old = static_cast<float>(step.old), fresh = static_cast<float>(step.fresh);
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < matrix.rows(); ++k) {
      const Index p = matrix.places[k];
      z[p] = old * z[p] + fresh * matrix.inverse_diagonal[k] * r[p];
      x[p] += z[p].template cast<double>();
    }
    apply(matrix, z, Az);
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < matrix.rows(); ++k) r[matrix.places[k]] -= Az[matrix.places[k]];
  }
}

template <int d>
void cycle(const Multilevel<d>& all, std::size_t level, const Coefficients<d>& r, Coefficients<d>& x) {
  const SplineSmoother<d>& matrix = all.levels[level];
  x.assign(matrix.grid.places, Coefficient<d>::Zero());
  if (level + 1 == all.levels.size()) {
    solve<d>(all.coarsest, matrix.places, r, x);
    return;
  }
  RoughCoefficients<d> left(r.size());
  for (std::size_t p = 0; p < r.size(); ++p) left[p] = r[p].template cast<float>();
  smooth(matrix, level == 0 ? spline_sweeps : coarse_sweeps, left, x);
  Coefficients<d> wide(r.size()), coarse_r, coarse_x;
  for (std::size_t p = 0; p < r.size(); ++p) wide[p] = left[p].template cast<double>();
  const auto& next = all.levels[level + 1].grid;
  coarsen(matrix.grid, wide, next, coarse_r);
  cycle(all, level + 1, coarse_r, coarse_x);
  add_refined(next, coarse_x, matrix.grid, x);
}

}  // namespace

template <int d>
Multilevel<d> multilevel(const BondOperator<d>& N) {
  Multilevel<d> all;
  double reach_of_bonds = 0;
  for (Index i = 0; i < N.particles(); ++i)
    for (Index n = N.begin[i]; n < N.begin[i + 1]; ++n)
      reach_of_bonds = std::max(reach_of_bonds, (N.X[N.other[n]] - N.X[i]).norm());
  const auto grid = grid_over<d>(N.X, reach_of_bonds);
  all.by_cell = particles_by_cell<d>(grid, N.X);
  all.smoother = bond_smoother<d>(N);
  SplineMatrix<d> matrix = spline_matrix<d>(N, grid, all.by_cell);
  all.levels.push_back(spline_smoother(matrix));
  const Index enough = std::clamp(N.particles() / particles_per_row, few_rows, most_rows);
  while (matrix.rows() > enough) {
    matrix = coarser(matrix);
    all.levels.push_back(spline_smoother(matrix));
  }
// Eigen would split its products among the threads, and their blocks, so the bits, with them: within a team
// it uses the one that calls.
#pragma omp parallel num_threads(2)
#pragma omp single
  all.coarsest = coarsest(matrix, N.X, N.volume_weight);
  return all;
}

template <int d>
BondWork<d> work_for(const Multilevel<d>& all) {
  const auto n = all.smoother.particle.size();
  return {RoughMultipliers<d>(n), RoughMultipliers<d>(n), RoughMultipliers<d>(n), RoughMultipliers<d>(n)};
}

template <int d>
void precondition(const BondOperator<d>& N, const Multilevel<d>& all, const Multipliers<d>& r,
                  BondWork<d>& work, Multipliers<d>& z) {
  const auto& particle = all.smoother.particle;
  const Index places = all.smoother.places();
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < places; ++p) work.r[p] = r[particle[p]].template cast<float>();
  smooth(all.smoother, bond_sweeps, work);
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < places; ++p) z[particle[p]] = work.r[p].template cast<double>();
  Coefficients<d> coarse_r, coarse_x;
  const auto& grid = all.levels[0].grid;
  restrict_to(grid, N.X, all.by_cell, z, coarse_r);
  cycle(all, 0, coarse_r, coarse_x);
#pragma omp parallel for schedule(static)
  for (Index p = 0; p < places; ++p) z[particle[p]] = work.x[p].template cast<double>();
  add_prolonged(grid, N.X, coarse_x, z);
}

#define PLUMB_INSTANTIATE(d)                                                                         \
  template Multilevel<d> multilevel<d>(const BondOperator<d>&);                                      \
  template BondWork<d> work_for<d>(const Multilevel<d>&);                                            \
  template void precondition<d>(const BondOperator<d>&, const Multilevel<d>&, const Multipliers<d>&, \
                                BondWork<d>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
