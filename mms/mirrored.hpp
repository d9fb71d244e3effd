#pragma once
#include <vector>

#include "lib/geometry/ghosts.hpp"
#include "mms/manufactured.hpp"

namespace plumb::mms {

/// True for a face on which only the normal component is prescribed.
inline bool is_roller(const FaceCondition& condition) {
  return condition.normal == roller.normal && condition.tangential == roller.tangential;
}

/// The roller faces of a box, behind which a mirror layout has images. InputError unless the
/// displacement is its own mirror image about each of them, u(R X) = R u(X) to rounding, and if there are
/// none.
template <int d>
std::vector<Wall> mirror_walls(const Manufactured<d>& solution);

}  // namespace plumb::mms
