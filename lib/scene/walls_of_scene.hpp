#pragma once
#include <vector>

#include "lib/input/section.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/contact.hpp"
#include "lib/schemes/scheme.hpp"
#include "lib/schemes/touching_bodies.hpp"

namespace plumb {

/// Reads the sections [[contact]] of a scene whose bodies are known. Throws SceneError.
std::vector<ContactOptions> read_contacts(const Section& root, const Scene& scene);

/// Refuses walls and several bodies beside a scheme that knows none.
void refuse_walls(const Section& root, const Scene& scene);

/// Says what a wall is and does, or how two bodies touch, to bodies of that material.
Statement said_of(const ContactOptions& contact, const MaterialChoice& material);

/// Says how several bodies touch where no [[contact]] says more.
Statement bodies_of(const Scene& scene);

/// How the bodies of a scene touch.
TouchOptions touch_of_scene(const Scene& scene);

/// The walls of a scene, with the stiffness of its material where they have none of their own. Particles of node layouts
/// lie on the surface of their body, others half a spacing [m] within it.
template <int d>
std::vector<RigidWall<d>> walls_of_scene(const Scene& scene, double spacing);

}  // namespace plumb
