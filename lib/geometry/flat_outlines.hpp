#pragma once
#include <array>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// Corners of the outlines of triangles that lie in the plane z = 0 (or another one of constant z): that of
/// the body first, counterclockwise, then those of its holes. Throws InputError with the place for triangles
/// of different z, for outlines that branch or cross, and for several bodies.
std::vector<std::vector<Vec<2>>> flat_outlines(const std::vector<std::array<Vec<3>, 3>>& triangles);

}  // namespace plumb
