#pragma once
#include <memory>
#include <optional>

#include "lib/actions/actions.hpp"
#include "lib/geometry/layout.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"
#include "mms/curved_surface.hpp"
#include "mms/manufactured.hpp"

namespace plumb::mms {

/// What makes a body follow a manufactured solution: everything is evaluated at the times of the stages.
struct DriveOptions {
  Layout layout = Layout::node;
  bool body_force = false;  ///< add s (finite-strain); without it the body is the one of the printed field
  /// If given, particles on the boundary and those no farther from it than this [m] follow the solution at
  /// their own positions, in all components, and nothing else is prescribed. A width of two support radii
  /// leaves no free particle, and none whose stress it reads, with a cut support.
  std::optional<double> held_band = {};
  /// Loads and prescribed accelerations see the time at which their step began in all stages: (30) as
  /// printed.
  bool loads_at_step_start = false;
  bool faces = true;  ///< the body fills a box, whose faces have the conditions of the solution's
};

/// Makes what drives a body along the solution: the body force (if asked for), the tractions P N on faces
/// where they are known, and the prescribed motion of components known on a face. Particles that belong to a
/// face: those on it (node layout), or the first layer (cell layout), which then gets the values of the
/// nearest point of the face, as a boundary condition there says. Rollers of a mirror layout prescribe
/// nothing. The circles of an annulus are left free unless there is a held band. `curved`: what follows the solution, and is
/// pulled, where the surface of the body is no face of a box; balls have no other. `modulus`: that
/// of pressure waves [Pa], beside which a traction counts as zero.
template <int d>
Actions<d> actions_of(const Cloud<d>& cloud, double modulus, const Manufactured<d>& solution,
                      const DriveOptions& options, const CurvedSurface<d>& curved = {});

/// Sets the exact displacement and velocity of the state's time and applies the actions that drive a body
/// along the solution. Prescribed components have the force rho u_tt, and after each step of the returned
/// integrator the exact u and u_t. The integrator keeps copies of what it needs: solution and options may go. Traction t acts on a particle as t A/V, A its share of the face.
template <int d>
ChosenIntegrator<d> drive(Solid<d>& solid, State<d>& state, ChosenIntegrator<d> integrator,
                          const Manufactured<d>& solution, const DriveOptions& options,
                          const CurvedSurface<d>& curved = {});

}  // namespace plumb::mms
