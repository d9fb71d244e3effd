#pragma once
#include <string>
#include <string_view>

#include "lib/schemes/default_cfl.hpp"

namespace plumb {

class Section;

/// Chooses finite elements on the nodes of a box and how they move. It is the section [element] of a scene.
struct ElementOptions {
  static constexpr std::string_view section = "element", subject = "elements",
                                    theory = "THEORY (15.7) to (15.10)";

  std::string order = "linear";    ///< linear | reduced: one point a cell, hourglass energy | quadratic
  std::string solve = "explicit";  ///< explicit: Verlet | newton: as [implicit] says
  double alpha = 2;                ///< of the hourglass energy, times the shear modulus; order "reduced" only
  double cfl = default_cfl;        ///< step over the limit of stability

  int degree() const { return order == "quadratic" ? 2 : 1; }
  bool one_point() const { return order == "reduced"; }
  bool by_newton() const { return solve == "newton"; }

  /// Reads the section. Throws SceneError.
  static ElementOptions read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
};

}  // namespace plumb
