#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/input/document.hpp"
#include "lib/input/key_notes.hpp"
#include "lib/input/scene_error.hpp"
#include "lib/scene/scene.hpp"

namespace plumb {

/// [expect]: the orders that a study declares before it is run, with the reason.
struct Expect {
  std::optional<double> l2, h1, velocity_l2, stress_l2;
  std::string reason;
};

/// What a study file is read for. Orders in space use every key of it; the others do not.
enum class StudyOf {
  space,        ///< plumb mms: motion on a sequence of spacings
  cost,         ///< plumb mms --work-precision: the same runs, their errors beside their cost
  time,         ///< plumb mms --temporal: steps on one cloud
  equilibrium,  ///< plumb static
  operators,    ///< plumb operators: the field of one time
};

/// A convergence study (plumb mms): one manufactured solution on a sequence of spacings, in SI units.
struct Study {
  std::string name;
  std::string solution;             ///< a name of the catalogue of manufactured solutions
  std::vector<double> spacings;     ///< d [m], from coarse to fine; each divides body.size
  std::optional<double> time;       ///< [s]; exactly one of time and periods is given
  std::optional<double> periods;    ///< end time as a multiple of the solution's period
  std::string force = "none";       ///< none: the field as printed | finite-strain: its body force added
  std::string quadrature = "both";  ///< gauss | nodal | both: nodal norms cost little, so both by default
  /// Particles on the boundary and those no farther from it than this [m] follow the solution in all
  /// components; absent: what the solution's faces say.
  std::optional<double> held_band;
  std::string surface =
      "displaced";  ///< curved surfaces follow the solution: displaced | pulled by its tractions
  std::map<std::string, double> parameters;  ///< [study.parameters] of the solution, SI units
  std::optional<Expect> expect;              ///< absent: orders are reported, not judged
  Body body;                                 ///< without spacing: use with_spacing(body, d)
  MaterialChoice material;
  Method method;
  std::vector<std::string> unused;  ///< sentences: keys of the file that its use does not look at

  int dimension() const { return static_cast<int>(body.size.size()); }
};

/// Reads and checks a study file. `solutions`: the valid names; empty: not checked here. Overrides as in
/// read_scene. Overrides that `use` does not look at are refused, and so are keys of the file that would make
/// it lie; the others are in Study::unused. Throws SceneError.
Study read_study(const std::string& path, const std::vector<std::string>& overrides = {},
                 const std::vector<std::string>& solutions = {}, StudyOf use = StudyOf::space);

/// Reads and checks a study that is there as text; `file_name` is for messages.
Study parse_study(const std::string& text, const std::string& file_name,
                  const std::vector<std::string>& overrides = {},
                  const std::vector<std::string>& solutions = {}, StudyOf use = StudyOf::space);

/// Reads and checks a study of which the document has been parsed. `notes`: takes down the keys that are
/// asked for.
Study study_of(const TomlValue& document, const std::string& file_name,
               const std::vector<std::string>& solutions, StudyOf use = StudyOf::space,
               KeyNotes* notes = nullptr);

}  // namespace plumb
