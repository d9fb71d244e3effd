#pragma once
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// A plane face of the body's box behind which particles have mirror images.
struct Wall {
  int axis;
  bool upper;
};

/// The image of a particle behind a wall, or behind the edge or corner where walls meet.
template <int d>
struct Ghost {
  Index real;                 ///< the particle
  std::array<int, d> across;  ///< per axis: -1 and +1 behind the lower and the upper wall, 0 not reflected
};

/// All images that a particle may see within R, ordered by `across` and then by particle. InputError if a
/// body between two walls is thinner than R: images of images would be seen.
template <int d>
std::vector<Ghost<d>> ghosts_behind(const Cloud<d>& cloud, const std::vector<Wall>& walls, double R);

/// What the reflection does to a vector, component by component: +1 or -1.
template <int d>
Vec<d> signs_of(const Ghost<d>& ghost);

/// Where the image of X is [m].
template <int d>
Vec<d> image_of(const Vec<d>& X, const Box<d>& box, const Ghost<d>& ghost);

/// The cloud with its images behind its last particle, as an irregular cloud (line = 0).
template <int d>
Cloud<d> with_ghosts(const Cloud<d>& cloud, const std::vector<Ghost<d>>& ghosts);

}  // namespace plumb
