#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "lib/schemes/tlsph/bonds/bond_table.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"
#include "lib/schemes/tlsph/compatible/projection_solver.hpp"

namespace plumb {

/// How a bond table is made compatible. The start table is the one of the bond options' estimator.
template <int d>
struct CompatibleOptions {
  /// How readily volumes change, relative to area vectors; 0: they are fixed but for the smallest linear
  /// change that gives the body its volume and its centroid. The smaller, the nearer they stay to Voronoi's
  /// and the safer from turning negative on irregular clouds (measured from 1e-1 to 1e-7), and the fewer
  /// iterations large clouds take.
  double volume_weight = 1e-7;
  /// The body's surface; box_surface unless another shape is given.
  std::function<Surface<d>(const Cloud<d>&)> surface = box_surface<d>;
  ProjectionSolver solver = ProjectionSolver::automatic;  ///< by the number of particles
  std::filesystem::path cache;  ///< folder of tables that were projected before; empty: none is kept
};

/// How a compatible table was made: known in closed form, or projected.
struct CompatibleReport {
  bool closed_form = false;          ///< lattice_closure.hpp; then nothing below is found
  std::string why_projected;         ///< why not, as the end of a sentence; empty if it was asked for
  double divergence_defect = 0;      ///< of the boundary vectors before their correction, relative
  double divergence_remainder = 0;   ///< and after it
  double start_residual = 0;         ///< largest violation of a constraint by the start table, in spacings
  double residual = 0;               ///< and by the projected one
  double largest_change = 0;         ///< of an area vector, in units of spacing^(d-1)
  double largest_volume_change = 0;  ///< of a volume, relative
  int refinements = 0;               ///< solutions, each for what the ones before left
  int iterations = 0;                ///< of the conjugate gradients; 0: solved directly
  int levels = 0;                    ///< of their V-cycle
  Index unknowns = 0;                ///< of the linear system; 0: nothing was solved
  bool from_cache = false;           ///< the table was read, and its constraints checked
};

/// Projects the stencils of all particles onto area vectors that are antisymmetric, closed and exact: the
/// least change, weighted by the kernel, for which the same vectors make F and the force (THEORY chapter 11).
/// Changes stencils, gradients and volumes. Throws InputError if the surface does not obey the divergence
/// theorem, if the constraints cannot be met to 1e-12, or if a volume is not positive.
template <int d>
CompatibleReport make_compatible(Cloud<d>& cloud, std::vector<std::vector<BondConstants<d>>>& bonds,
                                 const RadialKernel<d>& kernel, double h,
                                 const CompatibleOptions<d>& options = {});

/// Sets `project` of the bond options. The report, if wanted, is written when the table is made.
template <int d>
void project_compatible(BondOptions<d>& options, const CompatibleOptions<d>& how = {},
                        const std::shared_ptr<CompatibleReport>& report = nullptr);

}  // namespace plumb
