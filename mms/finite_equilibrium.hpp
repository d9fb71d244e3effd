#pragma once
#include <Eigen/Core>

#include "lib/scene/tlsph.hpp"
#include "mms/manufactured.hpp"

namespace plumb::mms {

/// Finds the displacements [m] of the body, d x particle + component, in equilibrium with -Div P of the solution at a
/// time [s] and displaced as it is on the whole surface of its box, by Newton's method on the way of `options`.
/// @throws InputError if no equilibrium is found
template <int d>
Eigen::VectorXd finite_equilibrium(TlsphBody<d>& body, const Manufactured<d>& solution, double time,
                                   const ImplicitOptions& options);

}  // namespace plumb::mms
