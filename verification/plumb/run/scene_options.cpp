#include "plumb/run/scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "plumb/run/inventory.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/scene/read_scene.hpp"

namespace plumb {
namespace {

/// Bytes per particle while a scene is built and run: the least that any scene takes. THEORY does not say;
/// measured with `plumb explain` (peak_rss over particles) on lattices, rounded down.
constexpr double least_bytes_2d = 600, least_bytes_3d = 1500;

void require_memory(const Scene& scene) {
  double particles = 1;
  for (const long along_edge : scene.body.particles) particles *= static_cast<double>(along_edge);
  const double needed = particles * (scene.dimension == 2 ? least_bytes_2d : least_bytes_3d);
  const auto available = static_cast<double>(available_bytes());
  if (available > 0 && needed > available)
    throw InputError(fmt::format("{:.3g} particles do not fit into memory", particles),
                     fmt::format("they need at least {:.1f} GB, the machine has {:.1f} GB free", needed / 1e9,
                                 available / 1e9),
                     "use a larger spacing");
}

}  // namespace

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

}  // namespace plumb
