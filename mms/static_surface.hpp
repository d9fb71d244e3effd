#pragma once
#include <vector>

#include "lib/scene/study.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/statics/statics.hpp"
#include "mms/curved_surface.hpp"
#include "mms/manufactured.hpp"

/// What a static study has on the surface of its body.
namespace plumb::mms {

/// Adds the tractions of a solution at rest to the load on each unknown [N], and returns the unknowns that are
/// displaced, with their values out of `u` [m]: of particles on the faces of a box, or of those that own a
/// piece of a displaced circle. Solutions that move are displaced on the whole surface, unless the study has curved surfaces that
/// are pulled.
template <int d>
std::vector<Prescribed> surface_conditions(const Study& study, const Manufactured<d>& solution,
                                           const Solid<d>& solid, double time, const Eigen::VectorXd& u,
                                           Eigen::VectorXd& load);

/// Finds what follows a solution that moves on the whole surface of a body at rest, and what is pulled: particles on the faces of a
/// box follow it, curved surfaces as the study says.
template <int d>
CurvedSurface<d> whole_surface(const Study& study, const Manufactured<d>& solution, const Solid<d>& solid);

/// Returns the components that the faces of a box hold still.
template <int d>
std::vector<Index> held_unknowns(const Cloud<d>& cloud, const Domain<d>& domain);

}  // namespace plumb::mms
