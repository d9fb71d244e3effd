#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/geometry/neighbours.hpp"
#include "lib/schemes/tlsph/bonds/estimator.hpp"
#include "lib/schemes/tlsph/bonds/mirror_bonds.hpp"
#include "lib/schemes/tlsph/bonds/momentum_form.hpp"

namespace plumb {

/// One particle's bonds, before they are packed.
template <int d>
struct BondConstants {
  Index other;        ///< particle number
  Vec<d> separation;  ///< X_ij [m]
  Vec<d> stencil;     ///< c_ij [1/m]
  Vec<d> gradient;    ///< V_j grad W~_j(X_i) [1/m]
  double laplacian;   ///< w_ij, without the volume
};

/// What acts at set-up and is gone afterwards.
template <int d>
struct BondOptions {
  RadialKernel<d> kernel;
  double smoothing_length;  ///< h [m]
  Correction pair;
  /// Constants c_ij of one particle: an estimator of the catalogue, or one that knows more than the
  /// neighbourhood (lattice_closure.hpp).
  std::function<std::vector<Vec<d>>(Neighbourhood<d>, const CorrectedKernel<d>&)> estimator;
  MomentumWeights<d> momentum;
  bool laplacian = false;        ///< weights of the corrected Laplacian (27), (28) for JST
  double laplacian_factor = 2;   ///< phi = -factor W'/r; 2 is the consistent one, 1 probably the paper's
  bool outer_transpose = false;  ///< outer level L^T V L instead of the symmetrised (28)
  std::vector<Wall> walls;       ///< faces behind which the particles have mirror images; not with `project`
  /// Changes the stencils (and, if it must, the volumes) of all particles together, once: the seam for tables
  /// that are projected onto global constraints. Empty: every particle's stencil comes from its own
  /// neighbourhood.
  std::function<void(Cloud<d>&, const Neighbours&, std::vector<std::vector<BondConstants<d>>>&)> project;
  /// Changes the force weights a_ij to the other particles, and s_i, of one particle after its momentum form
  /// has made them: the seam for corrections of the force that leave F alone. Empty: they stay as they are.
  /// Not for bodies with walls.
  std::function<void(const Cloud<d>&, Index i, std::span<const Index> others, std::span<Vec<d>> force,
                     Vec<d>& own)>
      adjust_force;
};

/// The reference neighbourhood as constants per bond: all that the kernel, the correction, the estimator and
/// the momentum form leave behind (THEORY (3.1), (5.1)). A row serves one pack of `width` consecutive slots:
/// the offsets are common, each lane has its own weights (zero where a lane lacks that neighbour). Equal
/// packs share one row, found by value, so that a lattice has some tens of rows; any other cloud has a row
/// per particle and width 1. One loop serves both.
template <int d>
struct BondTable {
  int width = 1;
  Slots slots;
  std::vector<std::int32_t> row;     ///< per pack: its row
  std::vector<std::int64_t> begin;   ///< per row: its first bond; one more at the end
  std::vector<std::int32_t> offset;  ///< per bond: slot of j minus slot of i
  AlignedVector separation;          ///< per bond, d x width: X_ij [m]
  AlignedVector stencil;             ///< per bond, d x width: c_ij [1/m]
  AlignedVector force;               ///< per bond, d x width: a_ij [1/m]; empty where c_ij serves for both
  AlignedVector identity;   ///< per row, d x d x width: sum_j X_ij (x) c_ij, I for a consistent estimator
  AlignedVector own_force;  ///< per row, d x width: s_i [1/m]
  AlignedVector laplacian;  ///< per bond, width: V_j w_ij [1/m^2]; empty unless asked for
  AlignedVector outer_laplacian;  ///< per bond, width: V_j (w_ij + w_ji)/2 or V_j w_ji [1/m^2]; as above
  AlignedVector own_outer;        ///< per row, width: sum_j V_j (w_ji - w_ij) [1/m^2]; only for the transpose
  std::optional<MirrorBonds<d>> mirror;  ///< bonds to images; none without walls
  std::int64_t pairs = 0;  ///< ordered pairs i != j of particles, and those of a particle and an image
  std::int64_t most_neighbours = 0;
  Index margin = 0;  ///< largest |offset| plus one pack

  /// a_ij [1/m], wherever they are kept. Compatible bonds have a_ij = c_ij, THEORY (11.4): F and the force
  /// then read the same vectors, those of the particle's own row.
  const AlignedVector& force_weights() const { return force.empty() ? stencil : force; }
  Index rows() const { return static_cast<Index>(begin.size()) - 1; }
  std::size_t bytes() const;  ///< without `mirror`
};

/// Builds the table; the cloud's volumes change only by options.project. Throws InputError naming the
/// particle, its position and the number of its neighbours where the neighbourhood is singular, and both
/// particles where two coincide.
template <int d>
BondTable<d> make_bond_table(Cloud<d>& cloud, const BondOptions<d>& options);

/// Bonds of particle i by the options' pair and estimator (without the particle itself).
template <int d>
std::vector<BondConstants<d>> bonds_of(const Cloud<d>& cloud, std::span<const std::int32_t> neighbours,
                                       Index i, const BondOptions<d>& options);

}  // namespace plumb
