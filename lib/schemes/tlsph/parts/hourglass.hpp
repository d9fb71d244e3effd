#pragma once
#include "lib/kernel/kernel.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Hourglass energy on the bonds of any table: what the deformation gradient of a particle does not explain
/// of the motion around it costs energy,
///   E = sum_i sum_j k_ij |x_ij - F_i X_ij|^2 / 2,  k_ij = alpha mu V_i w_ij / r_ij^2,  w_ij = V_j W_ij / sum
///   V W
/// (THEORY (12.1), paper 004 (21)-(28)). Zero for affine motion, frame-indifferent. Its force is minus its
/// derivative if the momentum form is the adjoint of F; then momenta and energy stay exact. alpha is
/// dimensionless and not negative.
template <int d>
Term<d> hourglass_term(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha);

}  // namespace plumb
