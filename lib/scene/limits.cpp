#include "plumbline/scene/limits.hpp"

#include <fmt/format.h>

namespace plumb {

std::vector<std::string> limits_of(const Scene& scene) {
  if (scene.method.gradient == "compatible") return {};
  const bool random = scene.body.cloud != "lattice";
  if (random || scene.body.jitter > 0)
    // report section compatible-evidence
    return {
        fmt::format("gradient = \"{}\" on {}: none of the tables but that of compatible bonds converges on "
                    "irregular clouds, since a uniform stress leaves a force there; use gradient = "
                    "\"compatible\"",
                    scene.method.gradient,
                    !scene.body.file.empty() ? "particles of a file"
                    : random                 ? "blue noise"
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
