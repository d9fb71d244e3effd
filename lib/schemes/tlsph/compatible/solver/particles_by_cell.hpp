#pragma once
#include "lib/schemes/tlsph/compatible/solver/spline_grid.hpp"

namespace plumb {

/// Particles by the cell of a grid that they are in, cells by blocks of 4^d, and blocks by colours: those of
/// one colour have no spline in common, so that each can be handled by another thread.
template <int d>
struct ParticlesByCell {
  std::vector<std::int32_t> particles;  ///< ascending within a cell
  std::vector<Index> begin;             ///< per cell that has particles: its first; one more at the end
  std::vector<Index> block_begin;       ///< per block: its first cell; one more at the end
  std::vector<Index> colour_begin;      ///< per colour: its first block; one more at the end
};
template <int d>
ParticlesByCell<d> particles_by_cell(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X);

/// x_i += values and gradients of the spline field, THEORY (11.8).
template <int d>
void add_prolonged(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const Coefficients<d>& c,
                   Multipliers<d>& x);

/// The transpose: c_k = sum_i B_k(X_i) l_i + L_i grad B_k(X_i).
template <int d>
void restrict_to(const SplineGrid<d>& grid, const std::vector<Vec<d>>& X, const ParticlesByCell<d>& by_cell,
                 const Multipliers<d>& r, Coefficients<d>& c);

}  // namespace plumb
