#include "lib/scene/limits.hpp"

#include <fmt/format.h>

#include "lib/scene/scheme_simulation.hpp"

namespace plumb {

namespace {

/// Of the swinging plate on rollers, THEORY chapter 11: amplitude 0.2 ends early at nu 0.495 and not at 0.3.
constexpr double near_incompressible = 0.49;

/// Differences over two cells do not see what alternates, and in 1D there is no other direction that would.
std::vector<std::string> limits_of_a_bar(const Method& method) {
  if (method.hourglass) return {};
  return {
      "motion that alternates from particle to particle is as soft in a bar as smooth motion, whatever the "
      "gradient; a smooth start does not set it off, a sudden load may: add [hourglass], which stiffens it"};
}

}  // namespace

std::vector<std::string> limits_of(const Scene& scene) {
  if (has_own_body(scene.method.scheme)) return {};
  if (scene.dimension == 1) return limits_of_a_bar(scene.method);
  if (scene.method.gradient == "compatible") {
    std::vector<std::string> found;
    if (scene.method.scheme != "tlsph" || scene.method.hourglass) return found;
    if (scene.material.poisson >= near_incompressible)
      found.push_back(fmt::format(
          "poisson = {:g} without [hourglass]: at large strains particles begin to alternate and the "
          "time step collapses; add [hourglass], whose alpha = 2 completes the same runs",
          scene.material.poisson));
    const bool shaped = scene.body.shape != "box" || !scene.body.holes.empty();
    if (shaped && scene.body.layout == Layout::cell)
      found.emplace_back(
          "particles that a surface clips, without [hourglass]: they alternate, and errors of motion are up "
          "to six times those with it; add [hourglass], whose alpha = 2 has order 2 there, or use layout = "
          "\"node\"");
    return found;
  }
  const bool random = scene.body.cloud != "lattice";
  if (random || scene.body.finer || scene.body.jitter > 0)
    // report section compatible-evidence
    return {
        fmt::format("gradient = \"{}\" on {}: none of the tables but that of "
                    "compatible bonds converges on irregular clouds, since a "
                    "uniform stress leaves a force there; use gradient = \"compatible\"",
                    scene.method.gradient,
                    !scene.body.file.empty() ? "particles of a file"
                    : random                 ? "blue noise"
                    : scene.body.finer       ? "cells of two sizes"
                                       : fmt::format("particles with jitter = {:g}", scene.body.jitter))};
  if (scene.body.layout != Layout::node || scene.method.momentum == "variational") return {};
  // plumb static with affine-patch: relative L2 error of u by momentum and gradient 0.008 to 0.010 at 5
  // spacings a side, 0.0013 to 0.0016 at 40, against 1e-15 of those recommended (a test repeats it)
  return {fmt::format(
      "momentum = \"{}\" with gradient = \"{}\" misses linear fields near the edges of a lattice (the "
      "patch test): displacements by 1 % at 5 spacings a side, 0.15 % at 40, and stresses there "
      "more; momentum = \"variational\" or gradient = \"compatible\" meets them",
      scene.method.momentum, scene.method.gradient)};
}

}  // namespace plumb
