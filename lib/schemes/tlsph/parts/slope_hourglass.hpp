#pragma once
#include "lib/kernel/kernel.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Hourglass energy of paper 004, (21): what no affine motion explains of the displacements around a
/// particle,
///   E = sum_i V_i alpha mu min_H sum_j w_ij |u_ij - H X_ij|^2 / r_ij^2,  w_ij = V_j W' r / sum V W' r.
/// THEORY (12.3), (12.4). The H that it takes is the corrected gradient of that paper, whatever table the
/// body has, so that it needs nothing of the table but its bonds. Its second derivative does not change.
/// `radius`: of each particle's support [m]; empty: that of the kernel.
/// alpha is the paper's: twice that of hourglass_term() on a cubic lattice.
template <int d>
Term<d> slope_hourglass_term(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha,
                             std::vector<double> radius = {});

}  // namespace plumb
