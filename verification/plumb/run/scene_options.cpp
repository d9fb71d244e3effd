#include "verification/plumb/run/scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/kernel/kernel.hpp"
#include "lib/scene/read_scene.hpp"
#include "verification/plumb/run/inventory.hpp"

namespace plumb::app {
namespace {

/// Bytes per particle that any scene takes while it is built and run: what `plumb explain` measured as
/// peak_rss over particles for large lattices at beta = 0.9 (2D 259, 3D 331), rounded down; for bars,
/// which were not measured, half of a plate's.
double least_bytes(const Scene& scene) {
  return scene.dimension == 1 ? 100 : scene.dimension == 2 ? 200 : 300;
}

/// Bytes of the bonds, at least. Measured at beta = 0.9 on jittered clouds: 3060 a particle in 2D with 9
/// neighbours, 7960 in 3D with 26, so some 300 a pair. Lattices keep one row for equal neighbourhoods: those
/// within a radius of the rim differ.
double bond_bytes(const Scene& scene) {
  const double support = plumb::with_dimension(
      scene.dimension, [&]<int d>() { return kernel_named<d>(scene.method.kernel).support; });
  const double reach = std::ceil(support * scene.method.beta);
  double rows = 1, neighbours = 1;
  for (const long along : scene.body.particles) {
    const auto n = static_cast<double>(along);
    rows *= scene.body.jitter > 0 ? n : std::min(n, 2 * reach);
    neighbours *=
        std::min(n, std::max(1.0, reach / 2));  // inscribed in the ball, and half of it cut off at a rim
  }
  return rows * neighbours * 100;
}

}  // namespace

void require_memory(const Scene& scene) {
  double particles = 1;
  for (const long along_edge : scene.body.particles) particles *= static_cast<double>(along_edge);
  const double needed = particles * least_bytes(scene) + bond_bytes(scene);
  const auto available = static_cast<double>(available_bytes());
  if (available > 0 && needed > available)
    throw InputError(
        fmt::format("{:.3g} particles at beta = {:g} do not fit into memory", particles, scene.method.beta),
        fmt::format("they need at least {:.1f} GB, the machine has {:.1f} GB free", needed / 1e9,
                    available / 1e9),
        "use a larger spacing or a smaller beta");
}

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE", options.file, "the scene file (.toml)")->required()->type_name("FILE");
  command.add_option("--set", options.overrides, "change one value of the scene; may be repeated")
      ->type_name("section.key=value")
      ->allow_extra_args(false);
}

Scene scene_of(const SceneOptions& options) {
  Scene scene = read_scene(options.file, options.overrides);
  require_memory(scene);
  return scene;
}

std::map<std::string, std::string> settings_of(const SceneOptions& options) {
  return scene_settings(options.file, options.overrides);
}

}  // namespace plumb::app
