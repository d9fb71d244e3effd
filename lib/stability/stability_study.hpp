#pragma once
#include <map>
#include <string>
#include <vector>

#include "lib/input/key_notes.hpp"
#include "lib/stability/trial.hpp"

namespace plumb {

/// What is driven to the edge. `stretch` needs no bisection: the scene pulls, and one run shows where it
/// ends.
enum class EdgeParameter { cfl, stretch, twist, poisson, eta4, beta, jitter };

/// One scheme of a study: a name and the overrides that make it.
struct Variant {
  std::string name;
  std::vector<std::string> set;
};

/// A map of stability (plumb stability): one parameter to its edge, at every value of a second, for every
/// variant.
struct StabilityStudy {
  std::string name;
  std::string scene;             ///< its text
  std::string file;              ///< and where it comes from, for messages
  std::vector<std::string> set;  ///< overrides for all runs
  EdgeParameter parameter = EdgeParameter::cfl;
  double from = 0, to = 0;  ///< where the edge is looked for; not for stretch
  double tolerance = 0.02;
  std::string over;                 ///< dotted key of the second parameter; empty: none
  std::vector<std::string> values;  ///< of it, as in a scene
  std::vector<Variant> variants;
  StabilityBounds bounds;
};

/// Reads a study file; `scene` in it, and `schemes`, a file of further variants, are relative to the file.
/// Throws SceneError.
StabilityStudy read_stability_study(const std::string& path, const std::vector<std::string>& overrides = {});

/// Finds every key that such a file may have, by asking its reader.
KeyNotes keys_of_stability_studies();

/// The overrides of one run: of the study, the variant, the second parameter, and `value` of the first.
std::vector<std::string> overrides_of(const StabilityStudy& study, const Variant& variant,
                                      const std::string& over_value, double value);
/// The scene of that run. A twist multiplies the formulas of initial.velocity.
Scene varied_scene(const StabilityStudy& study, const std::vector<std::string>& overrides, double value);

/// Returns the name of the parameter in study files.
std::string name_of(EdgeParameter parameter);

}  // namespace plumb
