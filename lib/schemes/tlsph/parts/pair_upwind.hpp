#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Makes the dissipation between pairs by the form R^T S R, THEORY (16.2), (16.3): w = v_b - v_a - (l_a + l_b) x_ab/2 with
/// spatial velocity gradients l, and the force from the potential sum q.w/2. It takes energy in any state, gives nothing to a
/// rigid rotation of any deformed state, and keeps both momenta, if the body's force is the adjoint one. Keeps 2 d d + d + 1
/// numbers per slot and one per bond. InputError for bodies with mirror images.
template <int d>
Term<d> pair_upwind_term(const Solid<d>& solid);

/// Returns the largest stable time step of that dissipation in the undeformed state [s]: dt times its largest rate <= limit, the
/// extent of the integrator's stability region on the negative real axis. A body that is compressed has shorter steps by the CFL
/// condition in the same measure.
template <int d>
double pair_upwind_step_limit(const Solid<d>& solid, double limit);

}  // namespace plumb
