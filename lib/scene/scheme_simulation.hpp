#pragma once
#include <string>
#include <vector>

#include "lib/run/simulation.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/contact.hpp"
#include "lib/schemes/touching_bodies.hpp"

/// Schemes of the room `schemes` in the harness, by the name in [method].
namespace plumb {

/// What a scheme starts from: particles, what acts on them, how they move at first, and what they may touch.
template <int d>
struct SchemeStart {
  Cloud<d> cloud;
  Actions<d> actions;
  InitialMotion<d> motion;
  std::vector<RigidWall<d>> walls = {};
  TouchOptions touch = {};  ///< of several bodies
};

/// Says that the scheme of that name works on a body of its own (all but "tlsph" do).
bool has_own_body(const std::string& scheme);

/// Says whether Newton's method goes from step to step, as [implicit] says: the scheme "implicit", and elements by choice.
bool solved_by_newton(const Method& method);

/// Makes the scheme that the scene names; its options are in the scene. Throws InputError.
template <int d>
Simulation<d> make_scheme_simulation(const Scene& scene, SchemeStart<d> start);

/// Makes the scheme that the scene names, with its cloud, actions and first motion from the scene, too.
template <int d>
Simulation<d> make_scheme_simulation(const Scene& scene);

}  // namespace plumb
