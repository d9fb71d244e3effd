#pragma once
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/scene/study.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "mms/manufactured.hpp"

/// What a study's body has on its surface where that is no face of a box: balls, discs, polygons, holes.
namespace plumb::mms {

/// Says whether the body of the study has a surface that is no face of a box.
bool has_curved_surface(const Study& study);

/// Lists what follows the solution on such a surface, and what its tractions pull.
template <int d>
struct CurvedSurface {
  std::vector<Index> displaced;        ///< particles that follow it in all components, ascending
  std::vector<LoadedPlace<d>> pulled;  ///< all others that have a piece, at the particle itself, with B_i
};

/// Finds them. [study] surface = "displaced": who owns a piece of the surface follows the solution. Areas that a piece leaves with
/// others, so that linear fields are exact, are pulled. "pulled": nobody follows it.
template <int d>
CurvedSurface<d> curved_surface(const Study& study, const Manufactured<d>& solution, const Solid<d>& solid);

/// Chooses those of the pulled ones that must follow the solution so that a body at rest cannot move: one half of a body that has no
/// faces of a box, those with X below its middle.
template <int d>
void hold_half(const Cloud<d>& cloud, CurvedSurface<d>& surface);

}  // namespace plumb::mms
