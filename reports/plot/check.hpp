#pragma once
#include <vector>

#include "reports/picture.hpp"

namespace plumb::reports::plot {

/// Refuses a picture that cannot be drawn. @throws InputError (see plumb::reports::save()).
void check(const Picture& picture);

/// Takes the points out that are not finite or not positive on a logarithmic axis, and says which.
/// @throws InputError if nothing of a series is left.
std::vector<Dropped> drop_impossible_points(Picture& picture);

}  // namespace plumb::reports::plot
