#include "mms/mirrored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"

namespace plumb::mms {
namespace {

/// Largest |u(R X) - R u(X)| at points spread over the box (a Weyl sequence) and seven times that share no
/// period [m].
template <int d>
double asymmetry(const Manufactured<d>& solution, const Wall& wall) {
  const Box<d>& box = solution.domain.box;
  Ghost<d> ghost{0, {}};
  ghost.across[wall.axis] = wall.upper ? +1 : -1;
  const double irrational[] = {0.7548776662466927, 0.5698402909980532, 0.3819660112501051};
  double worst = 0;
  for (int k = 1; k <= 7; ++k) {
    Vec<d> X;
    for (int a = 0; a < d; ++a) X[a] = box.origin[a] + box.size[a] * std::fmod(k * irrational[a], 1.0);
    const double t = 0.137 * k * solution.period;
    const Vec<d> there = solution.displacement(image_of(X, box, ghost), t);
    worst = std::max(worst, (there - signs_of(ghost).cwiseProduct(solution.displacement(X, t))).norm());
  }
  return worst;
}

}  // namespace

template <int d>
std::vector<Wall> mirror_walls(const Manufactured<d>& solution) {
  std::vector<Wall> walls;
  const bool box = solution.domain.shape == Domain<d>::Shape::box;
  for (int face = 0; box && face < 2 * d; ++face) {
    if (!is_roller(solution.domain.faces[static_cast<std::size_t>(face)])) continue;
    const Wall wall{face / 2, face % 2 == 1};
    const double found = asymmetry(solution, wall);
    if (found > 1e-13 * solution.domain.length())
      throw InputError(fmt::format("layout = \"mirror\" with {}", solution.name),
                       fmt::format("its displacement is not its own mirror image about {}{}: {:.3g} m off",
                                   "xyz"[wall.axis], wall.upper ? '+' : '-', found),
                       "Use layout = \"node\".");
    walls.push_back(wall);
  }
  if (walls.empty())
    throw InputError(fmt::format("layout = \"mirror\" with {}", solution.name),
                     "none of its faces is a roller: there is nothing to mirror", "Use layout = \"cell\".");
  return walls;
}

template std::vector<Wall> mirror_walls<1>(const Manufactured<1>&);
template std::vector<Wall> mirror_walls<2>(const Manufactured<2>&);
template std::vector<Wall> mirror_walls<3>(const Manufactured<3>&);

}  // namespace plumb::mms
