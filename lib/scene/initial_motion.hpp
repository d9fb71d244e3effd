#pragma once
#include "plumbline/run/run.hpp"
#include "plumbline/scene/scene.hpp"
#include "plumbline/schemes/scheme.hpp"

/// What a scene says of the start and of the steps, for any scheme.
namespace plumb {

/// Displacement and velocity of every particle by [initial]; empty where it says nothing.
template <int d>
InitialMotion<d> initial_motion(const Scene& scene, const Cloud<d>& cloud);

/// How far, and with which steps. A closed body, which nothing drives, gets a bound of its energy.
StepControl step_control(const Scene& scene);

}  // namespace plumb
