// [implicit] arc_length: a shallow arch that snaps through, beside the theory of shallow arches.
#include <gtest/gtest.h>

#include <algorithm>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"

namespace plumb {
namespace {

Scene arch(const std::vector<std::string>& set = {}) {
  return read_scene(PLUMBLINE_SOURCE_DIR "/verification/scenes/shallow-arch.toml", set);
}

/// How far the middle has sunk [m], and the load of both halves [N].
struct ArchPoint {
  double sunk, load;
};

ArchPoint point_of(const Simulation<2>& simulation) {
  double sunk = 0;
  const Snapshot<2> now = simulation.snapshot();
  for (std::size_t i = 0; i < now.X.size(); ++i)
    if (now.X[i][0] > 2 - 1e-9) sunk = -now.u[i][1];
  return {sunk, simulation.load_factor()};
}

/// A thrust and bending alone (tests/reference/shallow_arch.py): 3.598 N at 0.0539 m, and down from there.
TEST(ArcLengthScene, AShallowArchSnapsThrough) {
  Simulation<2> simulation = make_simulation<2>(arch()).simulation;
  std::vector<ArchPoint> points{point_of(simulation)};
  while (points.back().sunk < 0.13 && points.size() < 40) {
    ASSERT_FALSE(simulation.steps.advance(simulation.steps.allowed()));
    points.push_back(point_of(simulation));
    // the foot carries what presses one half
    EXPECT_NEAR(simulation.reactions().front().force[1], 0.5 * points.back().load, 1e-8);
  }
  const auto limit = std::max_element(points.begin(), points.end(),
                                      [](const ArchPoint& a, const ArchPoint& b) { return a.load < b.load; });
  EXPECT_NEAR(limit->load, 3.598,
              0.04 * 3.598);                // five particles across, and 1/50 of the length is thickness
  EXPECT_NEAR(limit->sunk, 0.0539, 0.003);  // a step sinks it by 0.005
  EXPECT_GT(points.back().sunk, 0.13);
  EXPECT_LT(points.back().load, 0.2 * limit->load);
}

/// A run that goes on from what was saved takes the same steps, in the same direction.
TEST(ArcLengthScene, GoesOnFromWhatWasSaved) {
  Simulation<2> whole = make_simulation<2>(arch()).simulation, second = make_simulation<2>(arch()).simulation;
  for (int n = 0; n < 2; ++n) ASSERT_FALSE(whole.steps.advance(whole.steps.allowed()));
  second.restore(whole.save());
  ASSERT_FALSE(whole.steps.advance(whole.steps.allowed()));
  ASSERT_FALSE(second.steps.advance(second.steps.allowed()));
  EXPECT_EQ(point_of(second).sunk, point_of(whole).sunk);
  EXPECT_EQ(point_of(second).load, point_of(whole).load);
}

TEST(ArcLengthScene, RefusesLoadsThatChangeInTime) {
  const std::string ramped = "boundary.2.traction=[\"0\", \"-12.5*t\"]";
  EXPECT_THROW(make_simulation<2>(arch({ramped})).simulation.load_factor(), InputError);
}

}  // namespace
}  // namespace plumb
