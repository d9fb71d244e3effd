#pragma once
#include <map>
#include <string>
#include <vector>

#include "lib/core/dimension.hpp"
#include "lib/scene/scene.hpp"

namespace CLI {
class App;
}

namespace plumb::app {

/// What every subcommand that reads a scene takes.
struct SceneOptions {
  std::string file;
  std::vector<std::string> overrides;  ///< --set section.key=value
};

/// Adds SCENE.toml and --set to a subcommand.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// Refuses a scene that needs more memory than the machine has, with the estimate. Throws InputError.
void require_memory(const Scene& scene);

/// Reads the scene and refuses one that needs more memory than the machine has, before any of it is taken.
/// Throws InputError.
Scene scene_of(const SceneOptions& options);

/// All settings of the scene with its overrides, by dotted key.
std::map<std::string, std::string> settings_of(const SceneOptions& options);

/// f.template operator()<d>() for the dimension d of the scene.
template <class F>
int with_dimension(const Scene& scene, F&& f) {
  return plumb::with_dimension(scene.dimension, f);
}

}  // namespace plumb::app
