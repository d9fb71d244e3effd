#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/parts/jst_options.hpp"

namespace plumb {

/// Makes the term; needs a bond table made with laplacian = true, whose options also choose the outer level.
/// Keeps one array of d components (two if eta2 is not zero).
template <int d>
Term<d> jst_term(const Solid<d>& solid, const JstOptions& options);

/// Spectral radius of d^4 x (outer x inner Laplacian), by power iteration: Lambda of THEORY (6.5),
/// dimensionless.
template <int d>
double biharmonic_radius(const Solid<d>& solid);

/// Largest stable time step for the fourth-order part [s]: dt eta4 C h^3 rho(outer x inner) <= limit, with
/// the extent of the integrator's stability region on the negative real axis as limit (2.51 for RK3, 2 for
/// forward differences). THEORY (6.5).
template <int d>
double jst_step_limit(const Solid<d>& solid, const JstOptions& options, double limit);

}  // namespace plumb
