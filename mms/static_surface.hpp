#pragma once
#include <vector>

#include "lib/scene/study.hpp"
#include "lib/schemes/tlsph/statics/statics.hpp"
#include "mms/manufactured.hpp"

/// What a static study has on the surface of its body.
namespace plumb::mms {

/// Adds the tractions of a solution at rest to the load on each unknown [N], and returns the unknowns that are
/// displaced, with their values out of `u` [m]: of particles on the faces of a box, or of those that own a
/// piece of a displaced circle. Solutions that move are displaced on the whole surface.
template <int d>
std::vector<Prescribed> surface_conditions(const Study& study, const Manufactured<d>& solution,
                                           const Cloud<d>& cloud, double time, const Eigen::VectorXd& u,
                                           Eigen::VectorXd& load);

/// Returns the particles on the surface, ascending: those on the faces of the box, and those whose cells end at a curve.
template <int d>
std::vector<Index> surface_particles(const Study& study, const Manufactured<d>& solution,
                                     const Cloud<d>& cloud);

/// Returns the components that the faces of a box hold still.
template <int d>
std::vector<Index> held_unknowns(const Cloud<d>& cloud, const Domain<d>& domain);

}  // namespace plumb::mms
