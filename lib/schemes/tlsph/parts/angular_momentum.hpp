#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// The least change of the forces of the terms before it that leaves them without resultant and without
/// torque, f_i += l + w (x-product) x_i (paper 003, (64)-(67); THEORY (5.4)-(5.6)): a free body then keeps
/// its angular momentum to round-off, with the arms of the integrator over whole steps. Behind it come
/// supports and loads, which may change momenta. Costs a stored force, the arms, and three passes over them.
/// Has no potential: it does work.
template <int d>
Term<d> angular_momentum_projection(const Solid<d>& solid);

}  // namespace plumb
