#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/input/document.hpp"
#include "lib/input/key_notes.hpp"
#include "lib/material/point.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {

/// [path]: how one point is deformed for a while. Exactly one of gradient and deformation is there.
struct PathPiece {
  double duration = 1;             ///< [s]
  long steps = 100;                ///< increments of equal length
  std::optional<Mat<3>> gradient;  ///< velocity gradient L [1/s], constant: F -> exp(L dt) F
  std::vector<std::vector<Expression>>
      deformation;  ///< F as formulas of the time since the first piece began
};

/// A material and what is done to a point of it, from rest. In 2D (rows of two) F_33 is 1, or found under
/// plane stress; in 1D the strain is uniaxial.
struct MaterialPath {
  MaterialChoice material;
  int dimension = 3;
  std::vector<PathPiece> pieces;
};

/// Reads and checks a path file: [material], and [path] or several [[path]] that follow each other. Overrides
/// as in read_scene. Throws SceneError.
MaterialPath read_material_path(const std::string& path, const std::vector<std::string>& overrides = {});
/// Reads and checks a path that is there as text; `file_name` is for messages.
MaterialPath parse_material_path(const std::string& text, const std::string& file_name,
                                 const std::vector<std::string>& overrides = {});
/// Reads and checks a path of which the document has been parsed. `notes`: takes down the keys that are asked
/// for.
MaterialPath material_path_of(const TomlValue& document, KeyNotes* notes = nullptr);

/// One instant of a path.
struct PathRow {
  double t = 0;  ///< [s]
  PointState state;
};

/// Takes a point along the path: the state at its start and after each increment. `steps`: of each piece in
/// place of its own. InputError with the time where det F is not positive or the stress is not finite.
std::vector<PathRow> follow(const MaterialPath& path, std::optional<long> steps = {});

}  // namespace plumb
