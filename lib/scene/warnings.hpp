#pragma once
#include <string>
#include <vector>

#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

/// Settings that can be computed with but may surprise, each as a sentence for people with what to do.
namespace plumb {

/// The first time step of a run and what it is chosen from.
struct FirstStep {
  double dt;        ///< [s]
  double crossing;  ///< time of a wave between the closest neighbours [s]
  double damping;   ///< extent of the integrator's stability region on the negative real axis
};

/// All of those below. The scene has been read, the solid built with its dissipation.
template <int d>
std::vector<std::string> warnings_of(const Scene& scene, const Solid<d>& solid, const FirstStep& step);

/// The symmetrised form (5.2) near free faces: its linearised operator lets motion grow at any time step, and
/// much faster once the support reaches past the diagonal neighbours, R >= 2 d. With the adjoint form nothing
/// grows, but wide supports have soft modes that are not smooth. Empty if there is nothing to say.
std::vector<std::string> wide_kernel_warnings(const Scene& scene, double radius_over_spacing);

/// The step against the one that JST bears, THEORY (6.5).
std::vector<std::string> jst_step_warnings(const Scene& scene, const FirstStep& step, double limit);

/// A lattice distance within 1e-9 of the support radius R: rounding decides whether those neighbours count.
template <int d>
std::vector<std::string> lattice_distance_warnings(const Cloud<d>& cloud, double R, double beta);

/// An initial velocity that the particles cannot represent: half way (or a third of the way) between
/// neighbours along an axis it differs from their linear interpolation by as much as a wave exp(i theta X/d)
/// with theta = pi does, relative to its spread.
template <int d>
std::vector<std::string> aliasing_warnings(const Scene& scene, const Cloud<d>& cloud);

}  // namespace plumb
