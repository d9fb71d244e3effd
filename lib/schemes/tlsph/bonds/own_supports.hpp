#pragma once
#include <vector>

#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {

/// Finds for each particle the distance to its k-th neighbour [m]: the radius of its support where supports
/// are chosen by number. A kernel is zero there, so that those at that distance do not count. InputError if
/// there are not so many particles.
template <int d>
std::vector<double> support_radii(const Cloud<d>& cloud, long k);

/// Kernel W with L^-1, paper 004 (10)-(12): c_ij = V_j L^-1 grad W, L = sum V_j grad W (x) X_ij. InputError
/// if the neighbours do not span the space.
template <int d>
std::vector<Vec<d>> normalised_kernel_gradient(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel);

/// Gives particle i the support of radius[i], with the table of normalised_kernel_gradient(). The dual
/// supports of the paper need no more: the adjoint force reads the vectors of the particles that see i.
template <int d>
void use_own_supports(BondOptions<d>& options, std::vector<double> radius);

}  // namespace plumb
