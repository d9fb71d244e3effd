#pragma once
#include "lib/schemes/tlsph/bonds/bond_table.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

namespace plumb {

/// Corrects the force weights of a table, particle by particle, so that a uniform stress P leaves the force
/// -P B_i (nothing inside of the body), whatever the cloud: the variationally consistent integration of Chen,
/// Hillman and Rueter (IJNME 95, 2013) to first order, THEORY (13.1)-(13.3). F stays as it is, so the force
/// is no longer the adjoint of F: linear momentum, angular momentum and energy are not kept. Sets
/// adjust_force of the options, whose kernel, smoothing length and momentum form are read. Throws InputError
/// if the surface cannot obey the divergence theorem.
template <int d>
void make_force_consistent(BondOptions<d>& options, const Cloud<d>& cloud, const Surface<d>& surface);

}  // namespace plumb
