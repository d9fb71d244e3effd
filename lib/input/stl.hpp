#pragma once
#include <array>
#include <string>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// The corners of a triangle, in the unit of the file.
using Triangle = std::array<Vec<3>, 3>;

/// Reads the triangles of an STL file, text or binary, whatever its name. The normals that stand there are
/// not used: the sequence of the corners says which side is outside. Triangles two of whose corners are the
/// same are left out: nothing is lost. Throws InputError with the place for what is no STL, is cut off or not
/// finite.
std::vector<Triangle> parse_stl(const std::string& bytes, const std::string& file_name);

}  // namespace plumb
