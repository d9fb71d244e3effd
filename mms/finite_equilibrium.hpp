#pragma once
#include <Eigen/Core>

#include "lib/scene/study.hpp"
#include "lib/scene/tlsph.hpp"
#include "mms/manufactured.hpp"

namespace plumb::mms {

/// Finds the displacements [m] of the study's body, d x particle + component, in equilibrium with -Div P of the solution at a
/// time [s] and displaced as it is on the whole surface, by Newton's method on the way of [implicit].
/// @throws InputError if no equilibrium is found
template <int d>
Eigen::VectorXd finite_equilibrium(const Study& study, TlsphBody<d>& body, const Manufactured<d>& solution,
                                   double time);

}  // namespace plumb::mms
