// Images behind walls.
#include "lib/geometry/ghosts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/geometry/neighbours.hpp"
#include "tests/support/clouds.hpp"

namespace plumb {
namespace {

/// Two images of one particle that differ by the sides of their walls only are at least twice the distance of
/// the walls apart, so no particle sees both: a bond is known by the particle and the signs of the
/// reflection, even in the thinnest body that is allowed.
TEST(Ghosts, NoParticleSeesTwoImagesOfAnotherBehindOppositeWalls) {
  const Box<2> box{Vec<2>(-0.3, 0.1), Vec<2>(4, 3)};
  const Cloud<2> regular = lattice<2>(box, {4, 3}, Layout::mirror);
  const std::vector<Wall> walls{{0, false}, {0, true}, {1, false}, {1, true}};
  for (const double jitter : {0.0, 0.3}) {
    const Cloud<2> cloud = jitter > 0 ? jittered<2>(regular, jitter, 7, Layout::mirror) : regular;
    const double R = box.size[1];  // as far as the nearer walls are apart
    const auto ghosts = ghosts_behind(cloud, walls, R);
    const Neighbours all = find_neighbours<2>(with_ghosts(cloud, ghosts), R);
    Index images = 0, opposite = 0;
    for (Index i = 0; i < cloud.size(); ++i) {
      std::set<std::tuple<Index, double, double>> seen;
      std::set<int> sides;
      for (const auto j : all.of(i)) {
        if (j < cloud.size()) continue;
        const auto& ghost = ghosts[j - cloud.size()];
        const Vec<2> signs = signs_of(ghost);
        EXPECT_TRUE(seen.insert({ghost.real, signs[0], signs[1]}).second)
            << i << " sees " << ghost.real << " twice";
        sides.insert(ghost.across[1]);
        ++images;
      }
      opposite += sides.count(-1) > 0 && sides.count(1) > 0;
    }
    EXPECT_GT(images, 0);
    EXPECT_GT(opposite, 0) << "a body in which nobody sees both walls shows nothing";
  }
}

}  // namespace
}  // namespace plumb
