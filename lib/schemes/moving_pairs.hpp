#pragma once
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/geometry/moving_neighbours.hpp"
#include "lib/geometry/position_text.hpp"

/// What schemes whose neighbours change share.
namespace plumb {

/// Says from how many particles on a loop is shared among threads.
constexpr Index particles_for_threads = 1000;

/// Calls use(i) for all particles, side by side; what it writes must be i's own.
template <class Use>
void for_particles(Index count, Use&& use) {
#pragma omp parallel for schedule(static) if (count >= particles_for_threads)
  for (Index i = 0; i < count; ++i) use(i);
}

/// What pair loops read: the list, the slope of the kernel, and the particles' positions [m], velocities [m/s]
/// and volumes [m^d]. slope(r) is W'(r)/r [m^-(d+2)], and 0 from 1/slope.per_reach on.
template <int d, class Slope>
struct MovingPairs {
  const PairList& list;
  Slope slope;
  const std::vector<Vec<d>>&x, &v;
  const std::vector<double>& V;

  Index count() const { return static_cast<Index>(x.size()); }
};

/// InputError if the list has two particles at one place: their pair has no direction.
template <int d>
void refuse_one_place(const PairList& list, const std::vector<Vec<d>>& x, double spacing) {
  constexpr double one_place = 1e-8;  // spacings
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i)
    for (const auto j : list.of(i))
      if ((x[i] - x[j]).norm() < one_place * spacing)
        throw InputError(fmt::format("particles {} and {} are at one place", i, j),
                         "a pair without a direction has no force", "move one of them");
}

/// Says whether neighbours with the moment M = sum V r (x) grad W of a particle span the space: their gradient
/// is then defined. `share`: of the determinant that as much weight in all directions has.
template <int d>
bool spans_space(const Mat<d>& M, double share) {
  return M.determinant() > share * std::pow(M.trace() / d, d);
}

/// InputError if they do not at the start, where the particle is at X [m].
template <int d>
void require_span(const Mat<d>& M, Index particle, const Vec<d>& X) {
  if (!spans_space<d>(M, 1e-6))
    throw InputError(fmt::format("the neighbours of particle {} at {} do not span the space", particle,
                                 position_text<d>(X)),
                     "its velocity gradient is not defined", "use a smaller spacing");
}

}  // namespace plumb
