#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Changes forces per reference volume [N/m^d], by slot, by the least that leaves them without resultant and without torque about
/// X + arm. `room`: of one vector per particle.
template <int d>
void take_torque_off(const Cloud<d>& cloud, const Slots& slots, const Arm<d>& arm, std::vector<Vec<3>>& room,
                     Field& force);

/// The least change of the forces of the terms before it that leaves them without resultant and without
/// torque, f_i += l + w (x-product) x_i (paper 003, (64)-(67); THEORY (5.4)-(5.6)): a free body then keeps
/// its angular momentum to round-off, with the arms of the integrator over whole steps. Behind it come
/// supports and loads, which may change momenta. Costs a stored force, the arms, and three passes over them.
/// Has no potential: it does work.
template <int d>
Term<d> angular_momentum_projection(const Solid<d>& solid);

}  // namespace plumb
