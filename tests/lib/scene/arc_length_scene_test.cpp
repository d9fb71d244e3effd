// [implicit] arc_length: a shallow arch that snaps through, beside the theory of shallow arches.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <tuple>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"
#include "tests/support/temporary_folder.hpp"

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

/// The arch with so many cells across: particles of a file, and a polygon through those on its surface.
Scene finer_arch(int cells, const test::TemporaryFolder& folder) {
  const double d = 0.04 / cells;
  const auto columns = static_cast<int>(std::lround(2 / d));
  const auto height = [d](int n) { return 0.1 * std::pow(std::sin(std::acos(-1.0) * n * d / 4), 2); };
  std::string points = "x,y\n", corners;
  for (int n = 0; n <= columns; ++n) {
    for (int m = 0; m <= cells; ++m) points += fmt::format("{:.12g},{:.12g}\n", n * d, height(n) + m * d);
    corners += fmt::format("[{:.12g}, {:.12g}], ", n * d, height(n));
  }
  for (int n = columns; n >= 0; --n) corners += fmt::format("[{:.12g}, {:.12g}], ", n * d, height(n) + 0.04);
  const auto file = folder / "arch.csv";
  std::ofstream(file) << points;
  return arch({"body.file=\"" + file.string() + "\"", "body.corners=[" + corners + "]"});
}

/// Loads at the highest and the lowest point of the path, by a parabola through the nearest ones.
std::array<double, 2> limit_points(Scene scene) {
  Simulation<2> simulation = make_simulation<2>(scene).simulation;
  std::vector<ArchPoint> points{point_of(simulation)};
  while (points.back().sunk < 0.17 && !simulation.steps.advance(simulation.steps.allowed()))
    points.push_back(point_of(simulation));
  std::array<double, 2> found{};
  for (std::size_t n = 1; n + 1 < points.size(); ++n) {
    const auto [a, b, c] = std::tie(points[n - 1], points[n], points[n + 1]);
    const double left = (b.load - a.load) / (b.sunk - a.sunk), right = (c.load - b.load) / (c.sunk - b.sunk),
                 second = (right - left) / (c.sunk - a.sunk);
    if (left * right > 0) continue;
    const double slope = left + second * (b.sunk - a.sunk);
    found[left > 0 ? 0 : 1] = b.load - slope * slope / (4 * second);
  }
  return found;
}

/// Both limit points are of second order in the spacing, and their limits, 3.57 and -0.413 N, near the theory's 3.598 and -0.419 N.
TEST(ArcLengthSceneLong, LimitPointsConvergeToTheTheory) {
  const test::TemporaryFolder folder;
  const auto coarse = limit_points(arch()), fine = limit_points(finer_arch(8, folder));
  EXPECT_NEAR(fine[0] + (fine[0] - coarse[0]) / 3, 3.598,
              0.01 * 3.598);  // thinner across its axis than upright
  EXPECT_NEAR(fine[1] + (fine[1] - coarse[1]) / 3, -0.419, 0.05 * 0.419);
  EXPECT_GT(coarse[1] - fine[1], 0.2);  // -0.096 and -0.334 N
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
