#include "plumb/run/scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "plumb/run/inventory.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/scene/read_scene.hpp"

namespace plumb {
namespace {

/// Bytes per particle that any scene takes while it is built and run: what `plumb explain` measured as
/// peak_rss over particles for large clouds at beta = 0.9 (2D 259, 3D 331 on lattices, 3060 and 7960
/// jittered), rounded down.
double least_bytes(const Scene& scene) {
  if (scene.body.jitter > 0) return scene.dimension == 2 ? 2500 : 7000;
  return scene.dimension == 2 ? 200 : 300;
}

void require_memory(const Scene& scene) {
  double particles = 1;
  for (const long along_edge : scene.body.particles) particles *= static_cast<double>(along_edge);
  const double needed = particles * least_bytes(scene);
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

std::map<std::string, std::string> settings_of(const SceneOptions& options) {
  return scene_settings(options.file, options.overrides);
}

}  // namespace plumb
