#pragma once
#include <vector>

#include "lib/input/section.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/contact.hpp"
#include "lib/schemes/scheme.hpp"

namespace plumb {

/// Reads the sections [[contact]]. Throws SceneError.
std::vector<ContactOptions> read_contacts(const Section& root, int dimension);

/// Refuses walls beside a scheme that knows none.
void refuse_walls(const Section& root, const Scene& scene);

/// Says what a wall is and does, to a body of that material.
Statement said_of(const ContactOptions& contact, const MaterialChoice& material);

/// The walls of a scene, with the stiffness of its material where they have none of their own. Particles of node layouts
/// lie on the surface of their body, others half a spacing [m] within it.
template <int d>
std::vector<RigidWall<d>> walls_of_scene(const Scene& scene, double spacing);

}  // namespace plumb
