#pragma once
#include "lib/run/run.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/scheme.hpp"

/// What a scene says of the start and of the steps, for any scheme.
namespace plumb {

/// Displacement and velocity of every particle by [initial]; empty where it says nothing.
template <int d>
InitialMotion<d> initial_motion(const Scene& scene, const Cloud<d>& cloud);

/// How far, and with which steps. A closed body, which nothing drives, gets a bound of its energy.
StepControl step_control(const Scene& scene);

}  // namespace plumb
