// The elastic flag of Turek and Hron (Lect. Notes Comput. Sci. Eng. 53, 371, 2006) by time steps: at rest and
// swinging, on a lattice of 8 cells across.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"

namespace plumb {
namespace {

const std::string scene_folder = PLUMBLINE_SOURCE_DIR "/verification/scenes/";
/// Particles within half a spacing of the cylinder are held.
const std::vector<std::string> coarse = {"body.spacing=0.0025",
                                         "boundary.0.where=(X + 0.05)^2 + (Y - 0.01)^2 < 0.05125^2"};

Index tip_of(const Snapshot<2>& shown) {
  Index nearest = 0;
  for (std::size_t i = 0; i < shown.X.size(); ++i)
    if ((shown.X[i] - Vec<2>(0.35, 0.01)).norm() < (shown.X[nearest] - Vec<2>(0.35, 0.01)).norm())
      nearest = static_cast<Index>(i);
  return nearest;
}

/// CSM1: the relaxation ends where Newton's method does, near the published numbers.
TEST(Flag, ComesToRestWhereItIsInEquilibrium) {
  Scene scene = read_scene(scene_folder + "flag-at-rest.toml", coarse);
  auto rest = make_simulation<2>(scene).simulation;
  const Index tip = tip_of(rest.snapshot());
  RunRecord history;
  ASSERT_TRUE(run<2>(rest, {}, history).completed());
  const Vec<2> at_rest = rest.at(tip).u;
  scene.relaxation.reset();
  scene.method.scheme = "implicit";
  auto direct = make_simulation<2>(scene).simulation;
  RunRecord other;
  ASSERT_TRUE(run<2>(direct, {}, other).completed());
  // a residual of 1e-7 in the softest motion, which is 1e3 times softer than what the supports feel
  EXPECT_NEAR((at_rest - direct.at(tip).u).norm(), 0, 1e-4 * at_rest.norm());
  EXPECT_NEAR(at_rest[1], -66.10e-3, 0.01 * 66.10e-3);
  EXPECT_NEAR(at_rest[0], -7.187e-3, 0.02 * 7.187e-3);
  // it carries the weight of what is not held: 0.35 x 0.02 m, and the lattice in front of the cylinder
  double weight = 0;
  const Snapshot<2> shown = rest.snapshot();
  for (std::size_t i = 0; i < shown.X.size(); ++i) weight += 2 * shown.mass[i];
  // forces of up to 1e-7 of a couple of 1e2 N that add up
  EXPECT_NEAR(rest.reactions()[0].force[1], weight, 1e-4 * weight);
}

/// CSM3: period and amplitude of the first swing.
TEST(Flag, SwingsAsPublished) {
  Scene scene = read_scene(scene_folder + "flag-swinging.toml", coarse);
  scene.end_time = 1;
  auto simulation = make_simulation<2>(scene).simulation;
  const Index tip = tip_of(simulation.snapshot());
  double lowest = 0, time_of_lowest = 0, highest_after = -1, time_of_highest = 0;
  RunRecord history;
  const auto look = [&] {
    const double u = simulation.at(tip).u[1], time = simulation.steps.now().time;
    if (u < lowest) {
      lowest = u;
      time_of_lowest = time;
    }
    if (time > 0.7 && u > highest_after) {
      highest_after = u;
      time_of_highest = time;
    }
    return true;
  };
  ASSERT_TRUE(run<2>(simulation, look, history).completed());
  EXPECT_NEAR(1 / time_of_highest, 1.0995, 0.015 * 1.0995);  // 8 cells across: the bar is 0.8 % too soft
  EXPECT_NEAR(2 * time_of_lowest, time_of_highest, 0.01);    // the swing is symmetric in time
  EXPECT_NEAR((highest_after - lowest) / 2, 65.160e-3, 0.01 * 65.160e-3);
}

}  // namespace
}  // namespace plumb
